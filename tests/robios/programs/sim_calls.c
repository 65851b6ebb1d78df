/* The simulated world's own calls: reading and setting are inverse. */
#include "eyebot.h"

int main() {
  int x, y, z, phi, angle, same = 1;

  for (angle = -180; angle <= 360; angle += 15) {
    SIMSetRobot(0, 700, 800, 10, angle);
    SIMGetRobot(1, &x, &y, &z, &phi);
    SIMSetRobot(1, x, y, z, phi);
    SIMGetRobot(0, &x, &y, &z, &phi);
    if (x != 700 || y != 800 || (angle - phi) % 360 != 0) same = 0;
  }
  printf("identity %d\n", same);
  printf("robots %d objects %d\n", SIMGetRobotCount(), SIMGetObjectCount());
  printf("unknown %d %d\n", SIMGetRobot(7, &x, &y, &z, &phi), SIMSetObject(3, 1, 2, 3, 4));
  printf("zeros %d %d %d\n", x, y, phi);
  VWGetPosition(&x, &y, &phi);
  printf("odometry %d %d %d\n", x, y, phi);
  return 0;
}
