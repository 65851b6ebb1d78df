/* As programs before 2018 count: 1 left, 2 front. */
#include "eyebot.h"

int main() {
  SIMSetRobot(0, 500, 1000, 0, 0); /* east wall 1500, north 1000 away */
  printf("1 %d 2 %d 3 %d raw %d\n", PSDGet(1), PSDGet(2), PSDGet(3), PSDGetRaw(2));
  printf("front %d left %d\n", PSD_FRONT, PSD_LEFT);
  return 0;
}
