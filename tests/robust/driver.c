/* Drives forwards for ever and says where it is five times a second; or what it learns about a
 * robot that is lost, and what is there when it is back. */
#include <string.h>

#include "eyebot.h"
#include "eyebridge.h"

int main() {
  char last[400] = "";
  int lost = 0;
  int x, y, phi, i;

  setvbuf(stdout, NULL, _IOLBF, 0);
  VWSetSpeed(100, 0);
  for (i = 0;; i++) {
    OSWait(20);
    if (VWGetPosition(&x, &y, &phi) != 0) {
      if (!lost || strcmp(last, EYEBRIDGELastError()) != 0) {
        snprintf(last, sizeof last, "%s", EYEBRIDGELastError());
        printf("lost: %s\n", last);
      }
      lost = 1;
    } else if (lost) {
      printf("back\n");
      OSWait(1500); /* nothing is commanded */
      VWSetSpeed(100, 0);
      lost = 0;
    } else if (i % 10 == 0) {
      printf("at %d\n", x);
    }
  }
  return 0;
}
