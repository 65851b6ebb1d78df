/* Follows the outer wall of a corridor on its right, round two corners, and stops before the third.
 * All that it knows of its place comes from its sensors. */
#include "eyebot.h"

#define KEEP_MM 240
#define SPEED_MM_S 250
#define CORNER_MM 260
#define PERIOD_MS 50

int main() {
  int corners = 0;
  int last = PSDGet(PSD_RIGHT);
  int near = 0; /* how often in a row there was a wall ahead: one reading may be wrong */

  setvbuf(stdout, NULL, _IOLBF, 0);
  printf("following\n");
  for (;;) {
    int right = PSDGet(PSD_RIGHT);
    int front = PSDGet(PSD_FRONT);
    int turn;

    near = front < CORNER_MM ? near + 1 : 0;
    if (near == 2) {
      if (++corners == 3) break;
      VWTurn(90, 90);
      VWWait();
      right = PSDGet(PSD_RIGHT);
      last = right;
      near = 0;
    }
    turn = (KEEP_MM - right) / 4 + 2 * (last - right);
    if (turn > 40) turn = 40;
    if (turn < -40) turn = -40;
    VWSetSpeed(SPEED_MM_S, turn);
    last = right;
    OSWait(PERIOD_MS);
  }
  VWSetSpeed(0, 0);
  OSWait(500);
  printf("three corners after %d ms\n", OSGetCount());
  return 0;
}
