/* Sensors by the numbers of the robot's file, bumpers that remember, a compass. */
#include "eyebot.h"
#include "tell.h"

static void distances() {
  PSDHandle left, front, odd;
  left = PSDInit(PSD_LEFT);
  front = PSDInit(PSD_FRONT);
  odd = PSDInit(-260);
  printf("handles %d %d %d\n", left, front, odd);
  TELL("none", PSDInit(PSD_RIGHT));
  TELL("twice", PSDInit(PSD_LEFT));
  TELL("unstarted", PSDGet(front));
  TELL("start", PSDStart(front | left, TRUE));
  TELL("join", PSDStart(odd, TRUE));
  TELL("wrong", PSDStart(64, TRUE));
  TELL("check", PSDCheck());
  OSWait(7);
  TELL("check", PSDCheck());
  TELL("left", PSDGet(left));
  TELL("odd", PSDGet(odd));
  TELL("raw", PSDGetRaw(front));
  TELL("tick", PSDGet(0));
  TELL("two", PSDGet(front | left));
  TELL("stop", PSDStop());
  TELL("once", PSDStart(front, FALSE));
  TELL("busy", PSDStart(front, FALSE));
  TELL("release", PSDRelease());
  TELL("after", PSDGet(front));
}

static void touches() {
  IRHandle ir = IRInit(IR_F);
  BumpHandle bump = BUMPInit(BUMP_FRONT);
  VWHandle vw;
  int stamp = 7;

  TELL("far", IRRead(ir));
  TELL("quiet", BUMPCheck(bump, &stamp));
  TELL("stamp", stamp);
  vw = VWInit(VW, 1);
  VWDriveStraight(vw, 3, 0.3);
  VWDriveWait(vw);
  TELL("near", IRRead(ir));
  VWDriveStraight(vw, -0.3, 0.3);
  VWDriveWait(vw);
  TELL("hit", BUMPCheck(bump, &stamp));
  TELL("stamped", stamp > 1000000);
  TELL("once only", BUMPCheck(bump, NULL));
  TELL("release", BUMPRelease(bump));
  printf("again %x\n", BUMPRelease(bump));
  TELL("ir release", IRRelease(ir));
  TELL("after", IRRead(ir));
  VWRelease(vw);
}

int main() {
  VWHandle vw;
  distances();
  touches();
  TELL("early", COMPASSGet());
  TELL("compass", COMPASSInit(COMPASS));
  TELL("start", COMPASSStart(TRUE));
  TELL("again", COMPASSStart(TRUE));
  TELL("check", COMPASSCheck());
  TELL("nothing yet", COMPASSGet());
  OSWait(10);
  TELL("check", COMPASSCheck());
  TELL("east", COMPASSGet());
  vw = VWInit(VW, 1);
  VWDriveTurn(vw, 1.5708, 1);
  VWDriveWait(vw);
  TELL("stop", COMPASSStop());
  TELL("north", COMPASSGet());
  TELL("calibrate", COMPASSCalibrate(0));
  TELL("bad mode", COMPASSCalibrate(2));
  TELL("release", COMPASSRelease());
  return 0;
}
