/* variables that survive, interrupts, tasks that are sent away, ports */
#include "eyebot.h"

struct tcb *worker;
int work = 0;

void job ()
{ while (1) { work++; OSReschedule(); if (work == 3) OSSuspend(0); }
}

int main ()
{ RadioIOParameters par;
  RadioStatus status;
  int t;

  LCDPrintf("%s\n%d MHz\n", OSMachineName(), OSMachineSpeed()/1000000);
  OSPutVar(SAVEVAR1,1234); OSPutVar(SAVEVAR2a,77);
  printf("saved %d %d\n", OSGetVar(SAVEVAR1), OSGetVar(SAVEVAR2a));
  OSDisable(); OSEnable();
  OSWriteParData(0x55); OSWriteParCTRL(3);
  printf("port %d %d %d\n", OSReadParData(), OSReadParCTRL(), OSReadParSR() >= 0);
  printf("latch %d, AD off %d\n", OSReadInLatch(0) >= 0, OSOffAD(0));
  RADIOGetIoctl(&par); par.debug = 0; RADIOSetIoctl(&par);
  RADIOInit();
  printf("radio status %d\n", RADIOGetStatus(&status));
  RADIOTerm();

  OSMTInit(COOP);
  worker = OSSpawn("job",job,SMALL_STACKSIZE,3,9);
  OSRun(worker);
  while (work < 3) OSReschedule();
  printf("worked %d times\n", work);
  OSKill(worker);
  t = OSGetCount();
  OSSleep(50);
  printf("slept %d\n", (OSGetCount() - t) / 10);
  OSError("strange number",42,FALSE);      /* waits for a key */
  OSExit(0);
  return 5;
}
