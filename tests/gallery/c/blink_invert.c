#include "eyebot.h"
int main()
{
  int i;
  LCDPrintf("inverted\n");
  LCDArea(50, 50, 150, 150, BLUE, 1);
  LCDAreaInvert(100, 100, 200, 200);
  LCDLineInvert(0, 50, 300, 250);
  for (i = 0; i < 100; i++) LCDPixelInvert(20 + i, 180);
  for (i = 0; i < 4; i++) { LCDAreaInvert(220, 50, 260, 90); OSWait(200); }   // even: as before
  printf("%06X %06X %06X\n", LCDGetPixel(60, 60), LCDGetPixel(120, 120), LCDGetPixel(190, 190));
}
