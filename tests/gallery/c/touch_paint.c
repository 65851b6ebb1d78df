// paint with the finger: every touch is joined to the one before
#include "eyebot.h"

int main()
{ int x, y, lastx, lasty, n = 1, none = 0;

  LCDMenu("clear", "", "", "END");
  LCDSetPrintf(0, 0, "touch me");
  KEYGetXY(&lastx, &lasty);
  LCDCircle(lastx, lasty, 4, GREEN, 1);
  printf("start %d %d\n", lastx, lasty);
  while (1)
  { if (KEYReadXY(&x, &y) == 0)
    { LCDLine(lastx, lasty, x, y, WHITE);
      LCDCircle(x, y, 4, RED, 1);
      printf("touch %d at %d %d\n", ++n, x, y);
      lastx = x; lasty = y;
    }
    else none++;
    if (KEYRead() == KEY4) break;   // the soft key can be touched, too
  }
  printf("%d touches, %s\n", n, none > 100 ? "mostly nothing" : "busy");
  LCDSetPrintf(0, 0, "%d touches", n);
}
