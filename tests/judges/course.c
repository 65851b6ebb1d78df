/* Drives a course and tells where it believes to be: x mm, y mm, degrees, and the seconds it took.
 */
#include <stdio.h>
#include <string.h>

#include "eyebot.h"

/* Whether a call failed; says which. */
static int failed(const char* call, int code) {
  if (code != 0) fprintf(stderr, "%s gave %d\n", call, code);
  return code != 0;
}

static int leg(int distance, int angle) {
  return failed("VWStraight", VWStraight(distance, 200)) || failed("VWWait", VWWait()) ||
         failed("VWTurn", VWTurn(angle, 90)) || failed("VWWait", VWWait());
}

int main(int argc, char** argv) {
  const int is_square = argc > 1 && strcmp(argv[1], "square") == 0;
  const int start = OSGetCount();
  int wrong = 0;
  if (is_square) {
    for (int i = 0; i < 4; ++i) wrong += leg(300, 90);
  } else {
    wrong += leg(500, 90);
  }
  const int took = OSGetCount() - start;
  int x = 0, y = 0, phi = 0;
  if (VWGetPosition(&x, &y, &phi) || wrong) return 1;
  printf("%d %d %d %.2f\n", x, y, phi, took / 1000.0);
  return 0;
}
