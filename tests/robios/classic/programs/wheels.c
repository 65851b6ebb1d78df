/* Motors, encoders and servos by handles that are added. */
#include <math.h>

#include "eyebot.h"
#include "tell.h"

int main() {
  MotorHandle left, right;
  QuadHandle ql, qr;
  ServoHandle pan, tilt;
  int ticks;
  float metres;

  left = MOTORInit(MOTOR_LEFT);
  right = MOTORInit(MOTOR_RIGHT);
  ql = QUADInit(QUAD_LEFT);
  qr = QUADInit(QUAD_RIGHT);
  printf("handles %d %d %d %d\n", left, right, ql, qr);
  TELL("drive", MOTORDrive(left | right, 50));
  TELL("wrong", MOTORDrive(8, 50));
  TELL("none", MOTORDrive(0, 50));
  OSWait(100);
  MOTORDrive(left + right, 0);
  OSWait(50);
  ticks = QUADRead(ql);
  TELL("counted", ticks > 1000);
  TELL("both", QUADRead(qr) == ticks);
  TELL("two", QUADRead(ql | qr));
  metres = QUADODORead(ql);
  TELL("metres", fabs(metres - ticks / (1100 / (M_PI * 0.054))) < 0.001);
  TELL("reset", QUADReset(ql | qr));
  TELL("now", QUADRead(ql));
  TELL("metres stay", fabs(QUADODORead(ql) - metres) < 0.001);
  TELL("odo", QUADODOReset(ql));
  printf("metres %.1f\n", QUADODORead(ql));
  TELL("motor", QUADGetMotor(QUAD_LEFT) == MOTOR_LEFT);
  TELL("motor", QUADGetMotor(QUAD_RIGHT) == MOTOR_RIGHT);
  TELL("no encoder", QUADGetMotor(MOTOR_LEFT));
  TELL("release", QUADRelease(ql | qr));
  TELL("again", QUADRelease(ql));
  printf("partly %x\n", MOTORRelease(left | 16));
  printf("not at all %x\n", MOTORRelease(32));
  TELL("release", MOTORRelease(left | right));
  pan = SERVOInit(SERVO1);
  tilt = SERVOInit(SERVO2);
  printf("servos %d %d\n", pan, tilt);
  TELL("no servo", SERVOInit(SERVO13));
  TELL("set", SERVOSet(pan | tilt, 128));
  TELL("too far", SERVOSet(pan, 256));
  TELL("wrong", SERVOSet(4, 0));
  TELL("release", SERVORelease(pan | tilt));
  printf("again %x\n", SERVORelease(pan));
  return 0;
}
