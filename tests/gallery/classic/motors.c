#include "eyebot.h"

int ticks = 0;
void count () { ticks++; }

int main ()
{ MotorHandle ml, mr;
  QuadHandle ql, qr;
  ServoHandle s1, s2;
  TimerHandle t;
  int a, b;

  ml = MOTORInit(MOTOR_LEFT);  mr = MOTORInit(MOTOR_RIGHT);
  ql = QUADInit(QUAD_LEFT);    qr = QUADInit(QUAD_RIGHT);
  s1 = SERVOInit(SERVO1);      s2 = SERVOInit(SERVO2);
  printf("handles %d\n", ml && mr && ql && qr && (ml & mr) == 0);
  t = OSAttachTimer(10,count);
  QUADReset(ql|qr);
  MOTORDrive(ml|mr,20);
  OSWait(200);
  a = QUADRead(ql); b = QUADRead(qr);
  MOTORDrive(ml|mr,0);
  LCDPrintf("L %d\nR %d\n",a,b);
  printf("%s\n", a > 0 && a == b ? "straight" : "crooked");
  SERVOSet(s1|s2,200);
  OSWait(100);
  SERVORelease(s1|s2);
  printf("timer %d, detach %d\n",ticks,OSDetachTimer(t));
  printf("wrong handle %d\n",MOTORDrive(0,10));
  MOTORRelease(ml|mr);
  QUADRelease(ql|qr);
  AUTone(440,300);
  while (!AUCheckTone());
  AUBeep();
  printf("%d ticks per second\n", 100);
  return 0;
}
