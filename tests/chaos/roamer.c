/* Drives by its ranges for ever and looks around: a robot of the chaos test. Says on standard
 * output when a frame fails ("blind"), when one comes again ("sees"), when its robot is "lost" and
 * "back". */
#include <stdio.h>

#include "eyebot.h"
#include "eyebridge.h"

static int changes(int now, int* before) {
  const int changed = now != *before;
  *before = now;
  return changed;
}

int main(void) {
  static BYTE frame[QVGA_SIZE];
  int blind = -1, lost = 0, x, y, phi;
  setvbuf(stdout, NULL, _IOLBF, 0);
  CAMInit(QVGA);
  for (int i = 0;; ++i) {
    const int is_near = PSDGet(1) < 250;
    VWSetSpeed(is_near ? 0 : 200, is_near ? 70 : 0);
    LCDPrintf("step %d\n", i);
    if (changes(CAMGet(frame) != 0, &blind)) puts(blind ? "blind" : "sees");
    if (changes(VWGetPosition(&x, &y, &phi) != 0, &lost)) {
      printf("%s %s\n", lost ? "lost" : "back", lost ? EYEBRIDGELastError() : "");
    }
    OSWait(50);
  }
}
