/* follow the left wall, no OSWait because we want to be fast */
#include "eyebot.h"
#define SAFE 200
#define STOP 180
#define SPEED 180

int main()
{ int l, f, r, diff, old = SAFE, steer, turns = 0, n = 0, rate = 0;

  LCDMenu("START", "", "", "END");
  KEYWait(KEY1);
  do
  { f = PSDGet(PSD_FRONT);
    l = PSDGet(PSD_LEFT);
    r = PSDGet(PSD_RIGHT);
    LCDSetPrintf(0, 0, "F%5d L%5d R%5d  ", f, l, r);
    if (f < STOP)
    { VWSetSpeed(0, 0);
      if (l < r) VWTurn(-90, 90);
      else       VWTurn(90, 90);
      VWWait();
      turns++;
      LCDSetPrintf(2, 0, "turns: %d", turns);
      old = PSDGet(PSD_LEFT);
    }
    else
    { diff = l - SAFE;
      if (diff > 80) diff = 80;
      if (diff < -80) diff = -80;
      if (++n % 10 == 0) { rate = l - old; old = l; }   // else it is always 0
      steer = diff / 4 + 2 * rate;
      if (steer > 40) steer = 40;
      if (steer < -40) steer = -40;
      VWSetSpeed(SPEED, steer);
    }
  } while (KEYRead() != KEY4);
  VWSetSpeed(0, 0);
  printf("%d turns\n", turns);
  return 0;
}
