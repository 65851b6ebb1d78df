/* Sensors by the numbers of the robot's file, bumpers that remember, a compass. */
#include "eyebot.h"

int main()
{ PSDHandle left, front, odd;
  IRHandle ir;
  BumpHandle bump;
  VWHandle vw;
  int stamp = 7, i;

  left = PSDInit(PSD_LEFT);
  front = PSDInit(PSD_FRONT);
  odd = PSDInit(-260);
  printf("handles %d %d %d, no %d, twice %d\n", left, front, odd, PSDInit(PSD_RIGHT),
         PSDInit(PSD_LEFT));
  printf("unstarted %d %d\n", PSDGet(front), PSDGet(left));
  printf("start %d %d %d\n", PSDStart(front | left, TRUE), PSDStart(odd, TRUE), PSDStart(64, TRUE));
  printf("check %d\n", PSDCheck());
  OSWait(7);
  printf("check %d, %d at %d, raw %d\n", PSDCheck(), PSDGet(front), PSDGet(0), PSDGetRaw(front));
  printf("wrong %d\n", PSDGet(front | left));
  PSDStop();
  printf("once %d %d\n", PSDStart(front, FALSE), PSDStart(front, FALSE));
  printf("release %d, after %d\n", PSDRelease(), PSDGet(front));

  ir = IRInit(IR_F);
  bump = BUMPInit(BUMP_FRONT);
  printf("ir %d bump %d, quiet %d, stamp %d\n", IRRead(ir), bump, BUMPCheck(bump, &stamp), stamp);
  vw = VWInit(VW, 1);
  VWDriveStraight(vw, 3, 0.3);
  VWDriveWait(vw);
  VWDriveStraight(vw, -0.3, 0.3);
  printf("near %d\n", IRRead(ir));
  VWDriveWait(vw);
  i = BUMPCheck(bump, &stamp);
  printf("hit %d, stamped %d\n", i, stamp > 1000000);
  printf("once only %d, released %x %x %d\n", BUMPCheck(bump, NULL), BUMPRelease(bump),
         BUMPRelease(bump), IRRelease(ir));

  printf("compass %d %d", COMPASSInit(COMPASS), COMPASSGet());
  printf(" %d", COMPASSStart(TRUE));
  printf(" %d %d", COMPASSStart(TRUE), COMPASSCheck());
  OSWait(10);
  printf(" %d %d\n", COMPASSCheck(), COMPASSGet());
  VWDriveTurn(vw, 1.5708, 1);
  VWDriveWait(vw);
  i = COMPASSStop();
  printf("stop %d, %d, calibrate %d %d, release %d\n", i, COMPASSGet(), COMPASSCalibrate(0),
         COMPASSCalibrate(2), COMPASSRelease());
  return 0;
}
