/* A submarine: thrusters, depth, and VW while it dives. For --robot USAL, in a room of 2 m. */
#include "eyebot.h"

/* Thrusters do not start in the same moment: every call takes its time. */
static const char* near(int value, int wanted, int within) {
  return value >= wanted - within && value <= wanted + within ? "fine" : "off";
}

static int height(void) {
  int x, y, z, phi;
  SIMGetRobot(0, &x, &y, &z, &phi);
  return z;
}

static void vertical(int percent) {
  MOTORDrive(2, percent);
  MOTORDrive(4, percent);
}

int main() {
  int x, y, z, phi, before;

  printf("floats %d\n", height());
  SIMSetRobot(0, 600, 1000, 1000, 0);
  SIMGetRobot(1, &x, &y, &z, &phi);
  printf("put %d %d %d %d, down %d\n", x, y, z, phi, PSDGet(6));
  vertical(-100);
  OSWait(2000); /* 135 mm/s and 0.8 s of drag */
  printf("dives %s\n", near(height(), 1000 - 171, 4));
  vertical(0);
  OSWait(20000); /* it rises by 15 mm/s */
  printf("rises %s, down %s\n", near(height(), 1000 - 171 - 120 + 300, 20),
         near(PSDGet(6), height(), 1));
  before = height();
  VWSetPosition(0, 0, 0);
  VWStraight(400, 150);
  vertical(-50);
  VWWait();
  vertical(0);
  VWGetPosition(&x, &y, &phi);
  printf("straight %s %d %d, deeper %d\n", near(x, 400, 2), y, phi, height() < before - 50);
  MOTORDrive(1, -50);
  MOTORDrive(3, 50);
  OSWait(3000);
  MOTORDrive(1, 0);
  MOTORDrive(3, 0);
  SIMGetRobot(0, &x, &y, &z, &phi);
  printf("turns %s\n", near(phi, 67, 3)); /* 30 deg/s and 0.8 s */
  printf("no encoder %d, no speed %d\n", ENCODERReset(1), MOTORSpeed(1, 10));
  SIMSetRobot(0, 1000, 1000, 9000, 0);
  SIMSetRobot(0, 1000, 1000, -5, 0);
  printf("floor %d\n", PSDGet(6));
  return 0;
}
