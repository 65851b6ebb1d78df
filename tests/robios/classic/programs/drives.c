/* The v-omega drive in metres and radians. */
#include "eyebot.h"
#include <math.h>

static VWHandle vw;

static void where(const char* what)
{ PositionType pos;
  VWGetPosition(vw, &pos);
  printf("%s %.2f %.2f %.2f\n", what, pos.x, pos.y, pos.phi);
}

int main()
{ SpeedType speed;
  int polls = 0;
  MotorHandle motor;

  printf("bad %d %d %d\n", VWInit(-1, 1), VWInit(VW_DRIVE, 0), VWDriveDone(1));
  motor = MOTORInit(MOTOR_LEFT);
  printf("taken %d\n", VWInit(VW_DRIVE, 1));
  MOTORRelease(motor);
  vw = VWInit(VW, 1);
  printf("handle %d, second %d, motor %d, encoder %d\n", vw, VWInit(VW_DRIVE, 1),
         MOTORInit(MOTOR_LEFT), QUADInit(QUAD_RIGHT));
  printf("control %d %d\n", VWStartControl(vw, 7, 0.3, 7, 0.1), VWStartControl(vw, 7, 0, 7, 0.1));
  VWDriveStraight(vw, 0.3, 0.2);
  printf("remain %.1f\n", VWDriveRemain(vw));
  while (!VWDriveDone(vw)) polls++;
  printf("polled %d\n", polls > 100);
  where("straight");
  VWDriveTurn(vw, M_PI / 2, 1.0);
  OSWait(80);
  printf("turned about half %d\n", fabs(VWDriveRemain(vw) - M_PI / 4) < 0.2);
  printf("wait %d\n", VWDriveWait(vw));
  where("turn");
  VWDriveCurve(vw, M_PI / 2 * 0.2, -M_PI / 2, 0.2);
  VWDriveWait(vw);
  where("curve");
  VWDriveStraight(vw, -0.1, 0.2);
  VWDriveWait(vw);
  where("back");
  VWSetPosition(vw, 1, 2, 3);
  where("set");
  VWSetSpeed(vw, 0.1, 0.5);
  OSWait(100);
  VWGetSpeed(vw, &speed);
  printf("speed %.2f %.2f\n", speed.v, speed.w);
  VWDriveStraight(vw, 5, 0.5);
  printf("hit %d stalled %d done %d\n", VWDriveWait(vw), VWStalled(vw), VWDriveDone(vw));
  printf("nulls %d %d %d\n", VWGetPosition(vw, NULL), VWGetSpeed(vw, NULL), VWSetSpeed(2, 1, 1));
  printf("nan %d\n", VWSetSpeed(vw, NAN, 0));
  printf("release %d, again %d, motor %d\n", VWRelease(vw), VWRelease(vw), MOTORInit(MOTOR_LEFT));
  return 0;
}
