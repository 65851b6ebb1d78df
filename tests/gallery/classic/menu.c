/* key test: each press once */
#include "eyebot.h"

int main ()
{ int k, slot = 0, done = FALSE;
  LCDClear();
  LCDMenu("+","-","GFX","END");
  while (!done)
  { k = KEYRead();
    if (k == KEY1) slot++;
    if (k == KEY2) slot--;
    if (k == KEY3)
    { LCDLine(0,8,127,52,1);
      LCDArea(90,10,120,30,1);
      LCDSetPixel(40,64,2); LCDInvertPixel(40,66);
      printf("pixel %d\n", LCDGetPixel(20,100));
      LCDMenu(" ","","",""); /* erase the first, keep the others */
    }
    if (k == KEY4) done = TRUE;
    if (k) { LCDSetPrintf(6,0,"slot %3d",slot); printf("slot %d\n",slot); }
    OSWait(5);
  }
  return 0;
}
