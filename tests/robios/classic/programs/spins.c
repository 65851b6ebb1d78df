/* In real time: main() waits in an empty loop for what a task sets. */
#include "eyebot.h"

int flag = 0, count = 0;

void setter() {
  while (count < 20) {
    count++;
    OSWait(1);
  }
  flag = 1;
}

int main() {
  OSMTInit(PREEMPT);
  OSReady(OSSpawn("s", setter, DEFAULT_STACKSIZE, MIN_PRI, 1));
  OSPermit();
  printf("main goes on\n");
  while (!flag)
    ;
  printf("counted %d\n", count);
  return 0;
}
