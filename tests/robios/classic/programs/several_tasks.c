/* Tasks of several robots: those of odd numbers take turns by preemption, the others by themselves.
   Consumers wait at a semaphore for what a producer and a timer give. */
#include "eyebot.h"

struct sem full, done;
int got[3];
int computed = 0;
VWHandle drive;

void consumer() {
  int me = OSGetUID(0), i;
  for (i = 0; i < 4; i++) {
    OSSemP(&full);
    got[me]++;
    VWSetSpeed(drive, 0.01 * got[me], 0.1 * me);
  }
  OSSemV(&done);
}

void producer() {
  int i;
  for (i = 0; i < 4; i++) {
    OSSleep(3);
    OSSemV(&full);
  }
  OSKill(0);
}

void computes() {
  while (got[1] + got[2] < 8) {
    computed++;
    OSGetCount();
  }
}

int given = 0;
void gives() {
  if (given++ < 4) OSSemV(&full);
}

int main() {
  int id = OSMachineID(), i, mode = id % 2 ? PREEMPT : COOP;
  struct tcb *tasks[2], *maker, *busy;
  TimerHandle timer;

  drive = VWInit(VW_DRIVE, 1);
  OSSemInit(&full, 0);
  OSSemInit(&done, 0);
  OSMTInit(mode);
  for (i = 0; i < 2; i++) tasks[i] = OSSpawn("consumer", consumer, 4096, MIN_PRI, i + 1);
  maker = OSSpawn("producer", producer, 4096, MIN_PRI, 3);
  busy = OSSpawn("computes", computes, 4096, MIN_PRI, 4);
  OSReady(tasks[0]);
  OSReady(tasks[1]);
  OSReady(maker);
  timer = OSAttachTimer(5, gives);
  if (mode == PREEMPT) {
    OSReady(busy);
    OSPermit();
  }
  OSSemP(&done);
  OSSemP(&done);
  OSDetachTimer(timer);
  if (mode == COOP) OSKill(busy); /* it never began */
  if (OSJoin(maker) != 0 || OSJoin(tasks[0]) != 0) printf("%d: not joined\n", id);
  printf("%d: mode %d got %d %d, computed %d\n", id, OSMTStatus(), got[1], got[2],
         mode == PREEMPT ? computed > 10 : computed);
  return 0;
}
