/* The same mistakes again and again, between calls that work; numbers at the ends of int. */
#include <limits.h>

#include "eyebot.h"

int main() {
  int i, x, y, phi;

  for (i = 0; i < 200; i++) {
    PSDGet(PSD_FRONT);
    PSDGet(9);
    PSDGet(10);
    LCDGetPixel(INT_MAX, i);
  }
  VWCurve(INT_MIN, INT_MIN, INT_MIN);
  VWTurn(INT_MAX, INT_MAX);
  VWSetSpeed(0, 0);
  VWSetPosition(INT_MAX, INT_MIN, 0);
  VWStraight(100, 100);
  VWWait();
  VWGetPosition(&x, &y, &phi);
  printf("position %d\n", x == INT_MAX && y == INT_MIN);
  printf("image %d %d\n", LCDImageStart(0, 0, INT_MAX, 1), LCDImageStart(0, 0, 0, 1));
  printf("speed %d %d\n", MOTORSpeed(1, 128), MOTORSpeed(1, -129));
  return 0;
}
