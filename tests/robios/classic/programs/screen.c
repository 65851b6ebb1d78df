/* Everything that writes and draws. */
#include "eyebot.h"
#include "tell.h"

int main(int argc, char** argv) {
  int row = -1, column = -1;
  BYTE bits[1024] = {0};

  LCDMode(SCROLLING | NOCURSOR);
  LCDPrintf("int %d %2d %4.1f\n", 42, 7, 3.14159);
  LCDPutString("string\n");
  LCDPutChar('c');
  LCDPutChar(NL);
  LCDPutHex(255);
  LCDPutHex1(0x1A5);
  LCDPutInt(-5);
  LCDPutIntS(6, 4);
  LCDPutFloatS(2.5, 6, 1);
  LCDSetPrintf(5, 10, "%s", "place");
  LCDSetString(6, 0, "last");
  LCDSetChar(6, 15, '*');
  LCDGetPos(&row, &column);
  printf("at %d %d\n", row, column);
  LCDMenu("A", "", "LONGER", "END");
  LCDMenuI(2, "two");
  TELL("no row", LCDSetPos(7, 0));
  TELL("no column", LCDSetChar(0, 16, 'x'));
  TELL("no key", LCDMenuI(5, "x"));
  TELL("no pixel", LCDSetPixel(64, 0, 1));
  TELL("no colour", LCDSetPixel(6, 0, 3));
  LCDSetPixel(20, 100, 1);
  LCDInvertPixel(20, 101);
  printf("pixels %d %d %d %d\n", LCDGetPixel(20, 100), LCDGetPixel(20, 101), LCDGetPixel(20, 102),
         LCDGetPixel(0, 128));
  LCDLine(100, 30, 120, 30, 1);
  LCDArea(100, 32, 120, 36, 2);
  printf("area %d %d\n", LCDGetPixel(30, 110), LCDGetPixel(34, 110));
  TELL("corners", LCDArea(5, 5, 4, 4, 1));
  TELL("nulls", LCDPrintf(NULL) + LCDPutString(NULL) + LCDPutGraphic(NULL) + LCDPutImage(NULL) +
                    LCDGetPos(NULL, NULL) + LCDSetString(0, 0, NULL));
  TELL("labels", LCDMenu(NULL, NULL, NULL, NULL));
  if (argc > 1) return 0;
  LCDClear();
  bits[0] = 0x80;
  LCDPutImage(bits);
  printf("bitmap %d %d\n", LCDGetPixel(0, 0), LCDGetPixel(0, 1));
  return 0;
}
