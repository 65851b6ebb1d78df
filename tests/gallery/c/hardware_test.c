/* test program for a new robot: motors, encoders, servos, controller - watch your fingers! */
#include "eyebot.h"

void motor_test(int m)
{ int i, start = ENCODERRead(m);
  for (i = 0; i <= 100; i += 25) { MOTORDriveRaw(m, i); OSWait(200); }
  MOTORDriveRaw(m, 0);
  OSWait(100);
  printf("motor %d turns %s\n", m, ENCODERRead(m) > start ? "forward" : "not at all");
  for (i = 0; i >= -100; i -= 25) { MOTORDrive(m, i); OSWait(200); }
  MOTORDrive(m, 0);
  OSWait(100);
  ENCODERReset(m);
}

int main()
{ int i, v, w;

  LCDMenu("MOTOR", "SERVO", "VW", "END");
  while (1)
  { switch (KEYGet())
    { case KEY1:
        motor_test(1); motor_test(2);
        MOTORPID(1, 4, 1, 1); MOTORSpeed(1, 10); OSWait(500); MOTORPIDOff(1); MOTORDrive(1, 0);
        break;
      case KEY2:
        printf("range %d, bad range %d\n", SERVORange(1, 50, 250), SERVORange(1, 250, 50));
        for (i = 0; i <= 255; i += 85) { SERVOSet(1, i); SERVOSetRaw(2, 255 - i); OSWait(100); }
        SERVOSet(1, 128); SERVOSet(2, 128);
        i = SERVOSet(1, 999);
        printf("bad servo %d, bad angle %d\n", SERVOSet(99, 0), i);
        break;
      case KEY3:
        printf("controller %s\n", VWControl(70, 30, 70, 10) ? "cannot be set" : "set");
        VWSetSpeed(100, 30);
        OSWait(1000);
        VWGetSpeed(&v, &w);
        printf("v %d w %d\n", v, w);
        VWSetSpeed(0, 0);
        printf("off: %d\n", VWControlOff());
        break;
      case KEY4:
        LCDSetPrintf(5, 0, "all tested");
        exit(0);
    }
  }
}
