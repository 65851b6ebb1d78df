// The second robot is the leader (we move it ourselves), robot 1 follows it with its PSD
#include "eyebot.h"
#define KEEP 250

int main()
{
  int i, d, x, y, z, phi, lx, ly, lphi, n = SIMGetRobotCount(), sum = 0;

  LCDPrintf("%d robots in this world\n", n);
  if (n < 2) { printf("nobody to follow\n"); return 1; }
  SIMSetRobot(2, 1200, 1000, 0, 0);
  for (i = 0; i < 200; i++)
  {
    SIMGetRobot(2, &lx, &ly, &z, &lphi);
    SIMSetRobot(2, lx + (i < 100 ? 8 : i < 150 ? 0 : -4), ly, 0, lphi);   // forward, stand, back
    d = PSDGet(PSD_FRONT);
    VWSetSpeed((d - KEEP), 0);
    if (i % 20 == 0)
    {
      SIMGetRobot(1, &x, &y, &z, &phi);
      LCDPrintf("%3d: I am at %4d, leader %4d, front %4d\n", i, x, lx, d);
    }
    if (i >= 140 && i < 150) sum += d;
    OSWait(50);
  }
  VWSetSpeed(0, 0);
  printf("distance when standing: %d\n", sum / 10);
  return 0;
}
