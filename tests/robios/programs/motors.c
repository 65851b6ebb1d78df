/* Motors, encoders and servos by number. */
#include "eyebot.h"

int main() {
  int left, right;

  ENCODERReset(1);
  ENCODERReset(2);
  MOTORSpeed(1, 5);
  MOTORSpeed(2, -5);
  OSWait(2000);
  left = ENCODERRead(1);
  right = ENCODERRead(2);
  printf("ticks %s\n", left > 950 && left < 1050 && right < -950 && right > -1050 ? "fine" : "off");
  MOTORDrive(1, 0);
  MOTORDrive(2, 0);
  ENCODERReset(1);
  printf("reset %d\n", ENCODERRead(1));
  printf("no motor %d, no encoder %d\n", MOTORDrive(9, 10), ENCODERReset(9));
  printf("servo %d %d %d\n", SERVOSet(1, 128), SERVOSet(1, 300), SERVOSet(40, 10));
  return 0;
}
