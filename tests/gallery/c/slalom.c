#include "eyebot.h"

void wait_done()
{ while (!VWDone()) {      /* spin */
    LCDSetPrintf(0, 0, "still %4d mm  ", VWRemain());
  }
}

int main()
{ int x, y, phi, i, v, w;

  LCDMenu("", "", "", "STOP");
  VWSetPosition(350, 1000, 0);
  VWStraight(275, 300); wait_done();
  VWTurn(51, 90); wait_done();
  for (i = 0; i < 2; i++)
  { VWCurve(860, -102, 250);  wait_done();
    VWGetPosition(&x, &y, &phi); printf("%d %d %d\n", x, y, phi);
    VWCurve(860, 102, 250);  wait_done();
    VWGetPosition(&x, &y, &phi); printf("%d %d %d\n", x, y, phi);
    LCDSetPrintf(2 + i, 0, "x %d y %d phi %d", x, y, phi);
  }
  VWDrive(300, -100, 200); wait_done();
  VWGetPosition(&x, &y, &phi); printf("%d %d %d\n", x, y, phi);
  VWCurve(-200, 30, 100); VWWait();                       /* a bit back */
  printf("cannot go sideways: %d\n", VWDrive(50, 300, 100));
  for (i = 0; i < 20; i++) { VWStraight(20, 200); OSWait(50); }   /* again and again */
  VWGetSpeed(&v, &w);
  printf("rolling at %d\n", v > 100);
  VWWait();
  VWGetPosition(&x, &y, &phi); printf("end %d %d %d\n", x, y, phi);
}
