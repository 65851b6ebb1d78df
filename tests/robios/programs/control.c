/* VWControl and VWControlOff. */
#include "eyebot.h"

int main() {
  int x, y, phi, stood;

  printf("control %d bad %d\n", VWControl(70, 30, 70, 10), VWControl(-1, 0, 0, 256));
  VWSetSpeed(200, 0);
  OSWait(500);
  printf("off %d\n", VWControlOff());
  OSWait(200);
  VWGetPosition(&stood, &y, &phi);
  OSWait(500);
  VWGetPosition(&x, &y, &phi);
  printf("drove %d stands %d\n", stood > 50, x == stood);
  VWStraight(100, 200);
  printf("again %d\n", VWWait());
  VWGetPosition(&x, &y, &phi);
  printf("on %d\n", x > stood + 90);
  return 0;
}
