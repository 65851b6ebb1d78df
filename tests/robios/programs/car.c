/* A car: VW as far as it can, then its motor and its steering servo. For --robot Car. */
#include "eyebot.h"

static void show(const char* what) {
  int x, y, phi;
  VWGetPosition(&x, &y, &phi);
  printf("%s %d %d %d\n", what, x, y, phi);
  VWSetPosition(0, 0, 0);
}

int main() {
  int x, y, z, phi, done;

  VWStraight(200, 200);
  VWWait();
  show("straight");
  VWCurve(400, 60, 200); /* the middle of the rear axle drives it, 80 mm behind the centre */
  VWWait();
  show("curve");
  VWCurve(-400, 60, 200);
  VWWait();
  VWSetPosition(0, 0, 0);
  VWTurn(90, 90); /* no car can */
  OSWait(500);
  printf("on the spot: stalled %d", VWStalled());
  done = VWWait();
  printf(", waited %d, done %d\n", done, VWDone());
  show("turn");
  SIMSetRobot(1, 1000, 1000, 10, 0);
  VWSetPosition(0, 0, 0);
  ENCODERReset(1);
  ENCODERReset(2);
  SERVOSet(1, 0); /* left */
  MOTORDrive(1, 20);
  OSWait(1000);
  MOTORDrive(1, 0);
  printf("left wheel %s\n", ENCODERRead(1) < ENCODERRead(2) ? "shorter" : "longer");
  SIMGetRobot(1, &x, &y, &z, &phi);
  printf("servo left: %s\n", phi > 60 && y > 1100 ? "turned left" : "did not");
  SERVOSet(1, 255);
  MOTORDrive(1, 20);
  OSWait(1000);
  MOTORDrive(1, 0);
  SIMGetRobot(1, &x, &y, &z, &phi);
  printf("servo right: %s\n", phi > -5 && phi < 5 ? "turned back" : "did not");
  printf("no motor %d\n", MOTORDrive(2, 20));
  return 0;
}
