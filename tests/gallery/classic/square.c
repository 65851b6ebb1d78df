#include "eyebot.h"
#include <math.h>

int main ()
{ VWHandle vw;
  PositionType pos;
  int i;

  vw = VWInit(VW_DRIVE,1);
  if (vw == 0) { LCDPutString("VWInit Error!\n"); OSWait(200); return 1; }
  VWStartControl(vw,7.0,0.3,7.0,0.1);
  for (i=0; i<4; i++)
  { VWDriveStraight(vw,0.4,0.3);
    while (!VWDriveDone(vw)) { LCDSetPrintf(6,0,"rest %4.2f",VWDriveRemain(vw)); OSWait(10); }
    VWDriveTurn(vw,M_PI/2,0.8);
    VWDriveWait(vw);
    VWGetPosition(vw,&pos);
    LCDPrintf("%4.2f %4.2f %4.1f\n",pos.x,pos.y,pos.phi);
    printf("%.2f %.2f %.2f\n",pos.x,pos.y,pos.phi);
  }
  VWDriveCurve(vw,0.3,M_PI/4,0.2);
  VWDriveWait(vw);
  printf("stalled %d\n",VWStalled(vw));
  VWStopControl(vw);
  VWRelease(vw);
  return 0;
}
