/* Mecanum wheels: four motors in every direction, then VW. For --robot Omni. */
#include "eyebot.h"

/* The motors do not start and stop in the same moment: every call takes its time. */
static int near(int value, int wanted, int within) {
  return value >= wanted - within && value <= wanted + within;
}

/* Drives a second with `sign` times 40 percent; 0.8 turns of a wheel of 100 mm and 5000 ticks. */
static void drive(const char* what, const int sign[4], int to_x, int to_y, int to_phi) {
  int x, y, z, phi, odo_x, odo_y, odo_phi, i;
  int good = 1;

  SIMSetRobot(1, 1000, 1000, 10, 0);
  VWSetPosition(0, 0, 0);
  for (i = 0; i < 4; i++) ENCODERReset(i + 1);
  for (i = 0; i < 4; i++) MOTORDrive(i + 1, sign[i] * 40);
  OSWait(1000);
  for (i = 0; i < 4; i++) MOTORDrive(i + 1, 0);
  OSWait(100);
  SIMGetRobot(1, &x, &y, &z, &phi);
  VWGetPosition(&odo_x, &odo_y, &odo_phi);
  for (i = 0; i < 4; i++) good = good && near(ENCODERRead(i + 1), sign[i] * 4000, 80);
  printf(
      "%s %s, odometry %s, encoders %s\n", what,
      near(x - 1000, to_x, 4) && near(y - 1000, to_y, 4) && near(phi, to_phi, 2) ? "fine" : "off",
      near(odo_x, to_x, 4) && near(odo_y, to_y, 4) && near(odo_phi, to_phi, 2) ? "fine" : "off",
      good ? "fine" : "off");
}

int main() {
  static const int left[4] = {-1, 1, 1, -1};
  static const int right[4] = {1, -1, -1, 1};
  static const int diagonal[4] = {0, 1, 1, 0};
  static const int ahead[4] = {1, 1, 1, 1};
  static const int spin[4] = {-1, 1, -1, 1};
  int x, y, phi;

  drive("left", left, 0, 251, 0);
  drive("right", right, 0, -251, 0);
  drive("diagonal", diagonal, 126, 126, 0);
  drive("ahead", ahead, 251, 0, 0);
  drive("spin", spin, 0, 0, 72); /* 251 mm at 200 mm: half of 220 and 180 together */
  printf("no motor %d, no encoder %d\n", MOTORDrive(5, 10), ENCODERReset(5));
  VWControlOff();
  VWSetPosition(0, 0, 0);
  VWCurve(314, 90, 200);
  VWWait();
  VWGetPosition(&x, &y, &phi);
  printf("curve %d %d %d\n", x, y, phi);
  return 0;
}
