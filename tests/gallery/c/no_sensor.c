// written for another robot: 8 PSDs, 4 motors, 6 servos, a compass ...
#include "eyebot.h"

const int PSD_DOWN = 6;
const int PSD_FL = 5;

int main()
{
  int i, n[10];

  LCDPrintf("test all sensors\n");
  for (i = 1; i <= 8; i++)
  {
    n[i] = PSDGet(i);
    LCDPrintf("PSD %d: %d (raw %d)\n", i, n[i], PSDGetRaw(i));
    printf("PSD %d %s\n", i, n[i] < 0 ? "is not there" : "works");
  }
  printf("down: %d, front left: %d\n", PSDGet(PSD_DOWN), PSDGet(PSD_FL));
  for (i = 1; i <= 4; i++)
  { int encoder = ENCODERRead(i);
    int motor = MOTORDrive(i, 0);
    printf("motor %d: %d, encoder %d: %d\n", i, motor, i, encoder);
  }
  for (i = 0; i <= 4; i++) printf("servo %d: %d\n", i, SERVOSet(i, 100));
  printf("robot 7: %d\n", SIMSetRobot(7, 100, 100, 0, 0));
  printf("stalled: %d\n", VWStalled());
  VWWait();      // nothing is driving
  VWStraight(0, 0);
  VWWait();
  VWTurn(0, 50);
  VWWait();
  printf("still here\n");
  return 0;
}
