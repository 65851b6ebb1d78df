/* drive between walls, PSDs as in the demo */
#include "eyebot.h"
#define THRES 175

int main ()
{ PSDHandle front, left, right;
  VWHandle vw;
  int f, l, r, t = 0;

  front = PSDInit(PSD_FRONT);
  left  = PSDInit(PSD_LEFT);
  right = PSDInit(PSD_RIGHT);
  if (!front || !left || !right) { LCDPrintf("no PSD\n"); return 1; }
  PSDStart(front|left|right,TRUE);
  vw = VWInit(VW,1);
  VWStartControl(vw,7,0.3,7,0.1);
  LCDMenu("","","","END");
  do
  { f = PSDGet(front); l = PSDGet(left); r = PSDGet(right);
    LCDSetPrintf(0,0,"F%4d L%4d R%4d",f,l,r);
    if (f < THRES)
    { VWDriveTurn(vw, l > r ? 1.5708 : -1.5708, 1.0);
      VWDriveWait(vw);
    }
    else if (l < THRES || r < THRES) VWSetSpeed(vw,0.2, l < r ? -0.3 : 0.3);
    else VWSetSpeed(vw,0.25,0.0);
    OSWait(5);
    t++;
  } while (KEYRead() != KEY4);
  VWSetSpeed(vw,0,0);
  PSDStop();
  PSDRelease();
  VWRelease(vw);
  printf("end %s\n", t > 100 ? "after a while" : "too early");
  return 0;
}
