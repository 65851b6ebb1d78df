/* Mecanum wheels: four motors in every direction, then VW. For --robot Omni. */
#include "eyebot.h"

static void drive(const char* what, int front_left, int front_right, int back_left,
                  int back_right) {
  int x, y, z, phi, odo_x, odo_y, odo_phi;
  int motor;

  SIMSetRobot(1, 1000, 1000, 10, 0);
  VWSetPosition(0, 0, 0);
  for (motor = 1; motor <= 4; motor++) ENCODERReset(motor);
  MOTORDrive(1, front_left);
  MOTORDrive(2, front_right);
  MOTORDrive(3, back_left);
  MOTORDrive(4, back_right);
  OSWait(1000);
  for (motor = 1; motor <= 4; motor++) MOTORDrive(motor, 0);
  OSWait(100);
  SIMGetRobot(1, &x, &y, &z, &phi);
  VWGetPosition(&odo_x, &odo_y, &odo_phi);
  printf("%s %d %d %d, odometry %d %d %d, encoders %d %d %d %d\n", what, x - 1000, y - 1000, phi,
         odo_x, odo_y, odo_phi, ENCODERRead(1), ENCODERRead(2), ENCODERRead(3), ENCODERRead(4));
}

int main() {
  int x, y, phi;

  drive("left", -40, 40, 40, -40);
  drive("right", 40, -40, -40, 40);
  drive("diagonal", 0, 40, 40, 0);
  drive("ahead", 40, 40, 40, 40);
  drive("spin", -20, 20, -20, 20);
  printf("no motor %d, no encoder %d\n", MOTORDrive(5, 10), ENCODERReset(5));
  VWControlOff();
  VWSetPosition(0, 0, 0);
  VWCurve(314, 90, 200);
  VWWait();
  VWGetPosition(&x, &y, &phi);
  printf("curve %d %d %d\n", x, y, phi);
  return 0;
}
