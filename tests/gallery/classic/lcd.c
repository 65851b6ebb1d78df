/* every way to write */
#include "eyebot.h"

colimage pic;
BYTE screen[1024];

int main ()
{ int r, c, row, col;
  char key;

  for (r = 0; r < 64; r++) for (c = 0; c < 16; c++) screen[16*r+c] = r < 32 ? 0xF0 : 0x0F;
  LCDPutImage(screen);
  LCDMenuI(1,"next"); LCDMenuI(4,"END");
  KEYGetBuf(&key);
  printf("key %d\n", key);
  LCDClear();
  for (r = 1; r <= 60; r++) for (c = 1; c <= 80; c++) pic[r][c][0] = pic[r][c][1] = pic[r][c][2] = 3*c;
  LCDPutColorGraphic(&pic);
  LCDSetPos(0,10); LCDPutHex(4711);
  LCDSetPos(1,10); LCDPutFloatS(2.5,6,2);
  LCDGetPos(&row,&col);
  printf("cursor %d %d\n", row, col);
  LCDMode(NONSCROLLING|NOCURSOR);
  LCDSetPos(2,10); OSShowTime();
  LCDMenu("","","","END");
  KEYWait(KEY4);
  return 0;
}
