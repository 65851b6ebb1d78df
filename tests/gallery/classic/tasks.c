/* two tasks and a semaphore, preemptive */
#include "eyebot.h"

struct tcb *t1, *t2, *master;
struct sem lcd;
int counter[2], ready = 0;

void task ()
{ int id = OSGetUID(0), i;
  for (i=0; i<10; i++)
  { OSSemP(&lcd);
    counter[id-1]++;
    LCDSetPrintf(id,0,"task %d: %3d",id,counter[id-1]);
    OSSemV(&lcd);
    OSSleep(10*id);
  }
  ready++;
  OSKill(0);
}

int main ()
{ OSMTInit(PREEMPT);
  OSSemInit(&lcd,1);
  t1 = OSSpawn("one",task,SMALL_STACKSIZE,MIN_PRI,1);
  t2 = OSSpawn("two",task,SMALL_STACKSIZE,MIN_PRI,2);
  if (!t1 || !t2) OSPanic("spawn failed");
  OSReady(t1);
  OSReady(t2);
  OSPermit();
  while (ready < 2) OSSleep(5);
  OSForbid();
  printf("%d %d\n",counter[0],counter[1]);
  LCDPrintf("all done\n");
  return 0;
}
