/* Slaves that share the screen by a semaphore, a master that waits: no task gives way by itself. */
#include "eyebot.h"
#define SLAVES 3

struct tcb* slave_p[SLAVES];
struct sem lcd;
int counts[SLAVES];

void slave() {
  int id = OSGetUID(0);
  while (1) {
    OSSemP(&lcd);
    LCDPrintf("slave %d: %d\n", id, ++counts[id]);
    OSSemV(&lcd);
    if (id == 2) OSWait(5);
  }
}

void timer() { OSSemV(&lcd); }

int main() {
  int i;
  TimerHandle t;
  OSMTInit(PREEMPT);
  OSSemInit(&lcd, 1);
  for (i = 0; i < SLAVES; i++) {
    slave_p[i] = OSSpawn("slave", slave, 8192, MIN_PRI, i);
    if (!slave_p[i]) OSPanic("spawn for slave failed");
  }
  for (i = 0; i < SLAVES; i++) OSReady(slave_p[i]);
  OSPermit();
  printf("master at %d\n", OSGetCount() / 100);
  OSWait(100);
  OSForbid();
  printf("%s\n", counts[0] > 100 && counts[1] > 100 ? "both ran" : "somebody starved");
  printf("waiter %d\n", counts[2] > 10 && counts[2] < counts[0]);
  printf("counts %d %d %d\n", counts[0], counts[1], counts[2]);
  for (i = 0; i < SLAVES; i++) OSKill(slave_p[i]);
  OSSemInit(&lcd, 0);
  t = OSAttachTimer(10, timer);
  OSSemP(&lcd);
  printf("a timer gave\n");
  OSDetachTimer(t);
  OSSemP(&lcd);
  printf("never\n");
  return 0;
}
