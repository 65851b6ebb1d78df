/* Motors timed with libc's sleep: the robot's clock must pass meanwhile. */
#include "eyebot.h"

int main() {
  struct timespec half = {0, 500000000};
  int x, y, phi, start;

  start = OSGetCount();
  VWSetSpeed(100, 0);
  usleep(1500000);
  sleep(1);
  nanosleep(&half, NULL);
  VWSetSpeed(0, 0);
  VWGetPosition(&x, &y, &phi);
  printf("waited %d\ndrove %d\n", OSGetCount() - start, x);
  return 0;
}
