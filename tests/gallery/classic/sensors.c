/* infrared switch, bumper, compass, odometer: what they say on the way to the wall */
#include "eyebot.h"

int main ()
{ BumpHandle bump; IRHandle ir; PSDHandle psd; VWHandle vw; QuadHandle quad;
  SpeedType speed;
  int stamp, t = 0, seen = 0;

  ir   = IRInit(IR_F);
  bump = BUMPInit(BUMP_FRONT);
  psd  = PSDInit(PSD_FRONT);
  quad = QUADInit(QUAD_LEFT);
  printf("encoder belongs to motor left: %d\n", QUADGetMotor(QUAD_LEFT) == MOTOR_LEFT);
  QUADODOReset(quad);
  printf("compass %d\n", COMPASSInit(COMPASS));
  COMPASSStart(FALSE);
  while (!COMPASSCheck()) OSWait(1);
  printf("heading %d\n", COMPASSGet());
  COMPASSCalibrate(0);
  COMPASSStop();
  COMPASSRelease();

  PSDStart(psd,TRUE);
  while (!PSDCheck()) OSWait(1);
  printf("front %d raw %d\n", PSDGet(psd), PSDGetRaw(psd));
  printf("odometer %.2f\n", QUADODORead(quad));
  QUADRelease(quad);                      /* the VW driver wants it */
  vw = VWInit(VW_DRIVE,1);
  VWStartControl(vw,7,0.3,7,0.1);
  VWSetPosition(vw,1.0,2.0,0.0);
  VWSetSpeed(vw,0.3,0.0);
  while (BUMPCheck(bump,&stamp) != 0 && t < 1000)
  { if (IRRead(ir) && !seen) { seen = 1; LCDPrintf("wall seen\n"); printf("front %s when the switch closes\n", PSDGet(psd) < 180 ? "near" : "far"); }
    if (t == 100) { VWGetSpeed(vw,&speed); printf("v %.1f w %.1f\n", speed.v, speed.w); }
    OSWait(1);
    t++;
  }
  VWSetSpeed(vw,0,0);
  LCDPrintf("bump!\n");
  printf("bump %s\n", t < 1000 ? "at the wall" : "missing");
  printf("second check %d\n", BUMPCheck(bump,&stamp));
  PSDStop(); PSDRelease();
  IRRelease(ir); BUMPRelease(bump); VWRelease(vw);
  return 0;
}
