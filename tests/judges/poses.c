/* Drives straight, again and again, and tells every pose that it is given and whether the drive is
 * done; of one that has failed for two seconds more. The arguments: drives, millimetres of each,
 * mm/s. */
#include <stdio.h>
#include <stdlib.h>

#include "eyebot.h"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  for (int i = atoi(argv[1]); i > 0; --i) {
    if (VWStraight(atoi(argv[2]), atoi(argv[3]))) return 1;
    for (int failed = 0; failed < 200;) {
      int x, y, phi;
      const int done = VWDone();
      if (VWGetPosition(&x, &y, &phi) == 0) printf("%d %d %d %d\n", x, y, phi, done);
      if (done == 1) break;
      failed += done < 0;
      OSWait(10);
    }
  }
  puts("end");
  return 0;
}
