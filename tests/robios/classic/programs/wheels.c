/* Motors, encoders and servos by handles that are added. */
#include "eyebot.h"
#include <math.h>

int main()
{ MotorHandle left, right;
  QuadHandle ql, qr;
  ServoHandle pan, tilt;
  int ticks;

  left = MOTORInit(MOTOR_LEFT);
  right = MOTORInit(MOTOR_RIGHT);
  ql = QUADInit(QUAD_LEFT);
  qr = QUADInit(QUAD_RIGHT);
  printf("handles %d %d %d %d\n", left, right, ql, qr);
  printf("drive %d, wrong %d, none %d\n", MOTORDrive(left | right, 50), MOTORDrive(8, 50),
         MOTORDrive(0, 50));
  OSWait(100);
  MOTORDrive(left + right, 0);
  OSWait(50);
  ticks = QUADRead(ql);
  printf("counted %d, both %d, wrong %d\n", ticks > 1000, QUADRead(qr) == ticks, QUADRead(ql | qr));
  printf("metres %d\n", fabs(QUADODORead(ql) - ticks / (1100 / (M_PI * 0.054))) < 0.001);
  printf("reset %d %d, metres stay %d\n", QUADReset(ql | qr), QUADRead(ql), QUADODORead(ql) > 0.1);
  printf("odo %d %.1f\n", QUADODOReset(ql), QUADODORead(ql));
  printf("motors %ld %ld %ld\n", (long)QUADGetMotor(QUAD_LEFT), (long)QUADGetMotor(QUAD_RIGHT),
         (long)QUADGetMotor(MOTOR_LEFT));
  printf("release %d %x %x\n", QUADRelease(ql | qr), MOTORRelease(left | 16), MOTORRelease(32));
  printf("all %d, wrong %d\n", MOTORRelease(left | right), QUADRelease(ql));
  pan = SERVOInit(SERVO1);
  tilt = SERVOInit(SERVO2);
  printf("servos %d %d, none %d\n", pan, tilt, SERVOInit(SERVO13));
  printf("set %d %d %d\n", SERVOSet(pan | tilt, 128), SERVOSet(pan, 256), SERVOSet(4, 0));
  printf("released %d %x\n", SERVORelease(pan | tilt), SERVORelease(pan));
  return 0;
}
