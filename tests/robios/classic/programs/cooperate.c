/* Two tasks that take turns by themselves, as in the text book. */
#include "eyebot.h"
#include "tell.h"
#define SSIZE 4096

struct tcb *task1, *task2;

void mytask() {
  int id, i;
  id = OSGetUID(0);
  for (i = 1; i <= 3; i++) {
    LCDPrintf("task %d : %d\n", id, i);
    printf("task %d : %d\n", id, i);
    OSReschedule();
  }
  OSKill(0);
  printf("never\n");
}

int main() {
  TELL("status", OSMTStatus());
  TELL("early", OSSpawn("t0", mytask, SSIZE, MIN_PRI, 0) != 0);
  TELL("init", OSMTInit(COOP));
  TELL("again", OSMTInit(COOP));
  TELL("status", OSMTStatus());
  task1 = OSSpawn("t1", mytask, SSIZE, MIN_PRI, 1);
  task2 = OSSpawn("t2", mytask, SSIZE, MIN_PRI, 2);
  if (!task1 || !task2) OSPanic("spawn failed");
  TELL("bad priority", OSSpawn("t3", mytask, SSIZE, MAX_PRI + 1, 3) != 0);
  OSReady(task1);
  OSReady(task2);
  OSReschedule();
  printf("back to main, uid %d, name %s\n", OSGetUID(0), task1->name);
  TELL("dead", OSReady(task1));
  TELL("dead", OSKill(task1));
  TELL("dead", OSGetUID(task1));
  TELL("permit", OSPermit());
  return 0;
}
