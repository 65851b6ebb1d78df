#include "eyebot.h"

image a, b, c;
image *cur = &a, *last = &b, *out = &c;

int main ()
{ image *swap;
  int i, r, k, n = 0, mode = 0;

  if (CAMInit(NORMAL) == NOCAM) return 1;
  LCDMenu("Lapl","Sob","Dith","END");
  for (i=0; i<12; i++)
  { swap = cur; cur = last; last = swap;
    CAMGetFrame(cur);
    switch (mode)
    { case 0: IPLaplace(cur,out); break;
      case 1: IPSobel(cur,out); break;
      case 2: IPDither(cur,out); break;
    }
    LCDPutGraphic(out);
    k = KEYGet();
    if (k == KEY4) break;
    mode = k == KEY1 ? 0 : k == KEY2 ? 1 : 2;
    LCDSetPrintf(0,10,"mode %d",mode);
  }
  IPDiffer(cur,last,out);
  for (r=1; r<61; r++) for (k=1; k<81; k++) if ((*out)[r][k] > 10) n++;
  printf("%s moved\n", n > 20 ? "something" : "nothing");
  CAMRelease();
  return 0;
}
