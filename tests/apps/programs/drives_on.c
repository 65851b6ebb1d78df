/* Drives for ever, and says when it moves. The test kills it: then something else must stop the
 * motors. */
#include "eyebot.h"

int main() {
  int x = 0, y, phi;
  VWSetSpeed(150, 0);
  while (x < 50) {
    VWGetPosition(&x, &y, &phi);
    OSWait(10);
  }
  printf("it drives\n");
  fflush(stdout);
  for (;;) OSWait(100);
}
