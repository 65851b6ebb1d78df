/* Drives a square of 400 mm, twice, and says where odometry thinks it ended. */
#include "eyebot.h"

int main() {
  int side, x, y, phi;

  LCDMenu("", "", "", "END");
  for (side = 0; side < 8; side++) {
    VWStraight(400, 200);
    VWWait();
    VWTurn(90, 90);
    VWWait();
    LCDPrintf("side %d done\n", side + 1);
  }
  VWGetPosition(&x, &y, &phi);
  LCDPrintf("back at %d %d, %d deg\n", x, y, phi);
  printf("back at %d %d, %d deg\n", x, y, phi);
  return 0;
}
