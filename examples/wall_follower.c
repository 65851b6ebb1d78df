/* Drives to the first wall ahead and follows it on its left at 150 mm, until KEY4 is pressed or a
 * minute is over.
 *
 * Proportional-derivative steering on the left PSD; a wall ahead is turned away from on the
 * spot. */
#include "eyebot.h"

#define KEEP_MM 150
#define SPEED_MM_S 150
#define FRONT_STOP_MM 120
#define PERIOD_MS 50

static int limit(int value, int most) {
  if (value > most) return most;
  if (value < -most) return -most;
  return value;
}

int main() {
  int last = KEEP_MM;
  int steps = 0;
  int found = 0;

  LCDMenu("", "", "", "END");
  while (KEYRead() != KEY4 && OSGetCount() < 60000) {
    int left = PSDGet(PSD_LEFT);
    int front = PSDGet(PSD_FRONT);

    if (front < FRONT_STOP_MM) {
      VWTurn(-90, 90); /* to the right, along the wall */
      VWWait();
      left = PSDGet(PSD_LEFT);
      found = 1;
    } else if (!found) {
      VWSetSpeed(SPEED_MM_S, 0);
    } else {
      int error = limit(left - KEEP_MM, 100);
      int rate = limit(left, 300) - limit(last, 300);
      VWSetSpeed(SPEED_MM_S, limit(error / 4 + 2 * rate, 60));
    }
    last = left;
    if (++steps % 10 == 0) LCDSetPrintf(0, 0, "left %4d  front %4d ", left, front);
    OSWait(PERIOD_MS);
  }
  VWSetSpeed(0, 0);
  LCDSetPrintf(1, 0, "stopped");
  return 0;
}
