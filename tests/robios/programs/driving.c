/* The VW family: ends, signs, replacing, done, remain, stall. */
#include "eyebot.h"

static void show(const char* what) {
  int x, y, phi;
  VWGetPosition(&x, &y, &phi);
  printf("%s %d %d %d\n", what, x, y, phi);
  VWSetPosition(0, 0, 0);
}

int main() {
  int v, w;

  VWWait(); /* nothing under way: at once */
  VWStraight(200, 100);
  printf("done %d", VWDone());
  OSWait(1000);
  printf(" remain %s\n", VWRemain() > 80 && VWRemain() < 130 ? "about half" : "wrong");
  VWWait();
  printf("done %d remain %d\n", VWDone(), VWRemain());
  show("straight");
  VWStraight(-200, 100);
  VWWait();
  show("back");
  VWTurn(-450, -90);
  VWWait();
  show("turn");
  VWTurn(90, 90);
  VWWait();
  show("turn");
  VWCurve(157, 90, 100);
  VWWait();
  show("curve");
  printf("not ahead %d\n", VWDrive(100, 200, 100));
  VWDrive(200, 100, 100);
  VWWait();
  show("drive");
  VWDrive(100, -100, 100); /* as far aside as ahead */
  VWWait();
  show("quarter");
  VWStraight(0, 0);
  VWWait();
  show("nothing");
  VWSetSpeed(100, 0);
  OSWait(1000);
  VWGetSpeed(&v, &w);
  printf("speed %d %d\n", v, w);
  VWSetSpeed(0, 0);
  OSWait(500);
  VWStraight(5000, 300);
  printf("stuck %d", VWWait());
  printf(" done %d stalled %d\n", VWDone(), VWStalled());
  return 0;
}
