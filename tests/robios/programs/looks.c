/* Looks at the time before its first call: it is the robot's from the first look on. */
#include <time.h>

#include "eyebot.h"

int main() {
  const time_t day = time(NULL);
  const clock_t start = clock();
  struct timespec now;
  sleep(2);
  clock_gettime(CLOCK_MONOTONIC, &now);
  printf("%ld, %ld s, %ld s, at %d\n", (long)day, (long)(clock() - start) / CLOCKS_PER_SEC,
         (long)now.tv_sec, OSGetCount());
  return 0;
}
