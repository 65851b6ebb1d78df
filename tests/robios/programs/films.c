/* Drives a square and films on the way: what a person with a webcam would bring home. */
#include "eyebot.h"

static BYTE frame[VGA_SIZE];

static void film(int frames) {
  while (frames-- > 0) CAMGet(frame);
}

int main() {
  CAMInit(VGA);
  for (int side = 0; side < 4; ++side) {
    VWSetSpeed(150, 0);
    film(90);
    VWSetSpeed(0, 45);
    film(60);
  }
  VWSetSpeed(0, 0);
  return 0;
}
