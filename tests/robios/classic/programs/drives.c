/* The v-omega drive in metres and radians. */
#include <math.h>

#include "eyebot.h"
#include "tell.h"

static VWHandle vw;

static void where(const char* what) {
  PositionType pos;
  VWGetPosition(vw, &pos);
  printf("%s %.2f %.2f %.2f\n", what, pos.x, pos.y, pos.phi);
}

int main() {
  SpeedType speed;
  int polls = 0;
  MotorHandle motor;

  TELL("no semantics", VWInit(-1, 1));
  TELL("no timescale", VWInit(VW_DRIVE, 0));
  TELL("not open", VWDriveDone(1));
  motor = MOTORInit(MOTOR_LEFT);
  TELL("taken", VWInit(VW_DRIVE, 1));
  MOTORRelease(motor);
  vw = VWInit(VW, 1);
  TELL("handle", vw);
  TELL("second", VWInit(VW_DRIVE, 1));
  TELL("its motor", MOTORInit(MOTOR_LEFT));
  TELL("its encoder", QUADInit(QUAD_RIGHT));
  TELL("control", VWStartControl(vw, 7, 0.3, 7, 0.1));
  TELL("bad control", VWStartControl(vw, 7, 0, 7, 0.1));
  VWDriveStraight(vw, 0.3, 0.2);
  printf("remain %.1f\n", VWDriveRemain(vw));
  while (!VWDriveDone(vw)) polls++;
  TELL("polled", polls > 100);
  where("straight");
  VWDriveTurn(vw, M_PI / 2, 1.0);
  OSWait(80);
  TELL("turned about half", fabs(VWDriveRemain(vw) - M_PI / 4) < 0.2);
  TELL("wait", VWDriveWait(vw));
  where("turn");
  VWDriveTurn(vw, -5, 2.0);
  OSWait(200);
  TELL("more than half a turn", fabs(VWDriveRemain(vw) - 1) < 0.3);
  VWDriveWait(vw);
  VWDriveTurn(vw, 5, 2.0);
  VWDriveWait(vw);
  VWDriveCurve(vw, M_PI / 2 * 0.2, -M_PI / 2, 0.2);
  VWDriveWait(vw);
  where("curve");
  VWDriveStraight(vw, -0.1, 0.2);
  VWDriveWait(vw);
  where("back");
  VWDriveCurve(vw, 0, 1, 0.2);
  TELL("no length", VWDriveDone(vw));
  VWSetPosition(vw, 1, 2, 3);
  where("set");
  VWSetSpeed(vw, 0.1, 0.5);
  OSWait(100);
  VWGetSpeed(vw, &speed);
  printf("speed %.2f %.2f\n", speed.v, speed.w);
  VWDriveStraight(vw, 5, 0.5);
  OSWait(1500);
  TELL("stalled", VWStalled(vw));
  TELL("given up", VWDriveWait(vw));
  TELL("done", VWDriveDone(vw));
  TELL("null", VWGetPosition(vw, NULL));
  TELL("null", VWGetSpeed(vw, NULL));
  TELL("wrong", VWSetSpeed(2, 1, 1));
  TELL("nan", VWSetSpeed(vw, NAN, 0));
  TELL("release", VWRelease(vw));
  TELL("again", VWRelease(vw));
  TELL("its motor", MOTORInit(MOTOR_LEFT));
  return 0;
}
