/* One short motion, chosen by the first argument. What it believes at the end goes to stdout. */
#include "eyebot.h"

static void finish(void) {
  int x, y, phi;
  OSWait(300); /* the last ramp */
  VWGetPosition(&x, &y, &phi);
  printf("believes %d %d %d\n", x, y, phi);
}

static void keep(int v, int w, int ms) {
  VWSetSpeed(v, w);
  OSWait(ms);
  VWSetSpeed(0, 0);
}

int main(int argc, char** argv) {
  const int which = argc > 1 ? atoi(argv[1]) : 0;

  switch (which) {
    case 0:
      VWStraight(400, 200);
      break;
    case 1:
      VWStraight(-300, 150);
      break;
    case 2:
      VWTurn(90, 90);
      break;
    case 3:
      VWTurn(-180, 120);
      break;
    case 4:
      VWCurve(300, 90, 150);
      break;
    case 5:
      VWCurve(-250, 60, 150);
      break;
    case 6:
      VWDrive(300, 120, 200);
      break;
    case 7: /* one movement replaces another */
      VWStraight(800, 200);
      OSWait(800);
      VWTurn(45, 90);
      break;
    case 8:               /* up to a wall */
      VWSetSpeed(100, 0); /* slow enough for a board that tells its ranges every 50 ms */
      while (PSDGet(PSD_FRONT) > 400) OSWait(20);
      VWSetSpeed(0, 0);
      break;
    default:
      keep(150, 45, 4000);
      break;
  }
  if (VWWait() != 0) printf("missed\n");
  finish();
  return 0;
}
