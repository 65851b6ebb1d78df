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

  for (;;) {
    int right = PSDGet(PSD_RIGHT);
    int front = PSDGet(PSD_FRONT);
    int turn;

    if (front < CORNER_MM) {
      if (++corners == 3) break;
      VWTurn(90, 90);
      VWWait();
      right = PSDGet(PSD_RIGHT);
      last = right;
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
