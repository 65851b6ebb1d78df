#include "eyebot.h"

int main() {
  VWStraight(300, 200);
  VWWait();
  VWTurn(90, 90);
  VWWait();
  int x, y, phi;
  VWGetPosition(&x, &y, &phi);
  printf("at %d %d %d\n", x, y, phi);
  return 0;
}
