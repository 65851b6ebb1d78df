/* a program from 2016: initialises everything, uses the old names and numbers */
#include "eyebot.h"
#define PSD_LEFT 2

int scan[360];

int main()
{
  int i, x, y, phi, min = 9999, where = 0;

  XInitThreads();
  LCDInit();
  KEYInit();
  LCDClear();
  LCDPrintf("old program\n");
  VWSetPosition(0, 0, 0);
  VWStraight(300, 200);
  while (VWDriveDone() == 0) LCDSetPrintf(2, 0, "%4d left", VWDriveRemain());
  VWTurn(45, 45);
  VWDriveWait();
  VWGetPosition(&x, &y, &phi);
  printf("%d %d %d\n", x, y, phi);

  SIMLaserScan(scan);            // 0 is the front, counter-clockwise
  for (i = 0; i < 360; i++) if (scan[i] < min) { min = scan[i]; where = i; }
  printf("next wall %d mm at %d degrees, left %d\n", min, where, PSDGet(PSD_LEFT) > 0);
  LCDSetPrintf(3, 0, "wall at %d", where);
  KEYRelease();
  LCDRelease();
  return 0;
}
