#include "eyebot.h"

char order[40];
int n = 0;

void worker ()
{ int i;
  for (i=0; i<3; i++) { order[n++] = '0' + OSGetUID(0); OSYield(); }
  OSKill(0);
}

int main ()
{ int i;
  struct tcb *t;
  OSMTInit(COOP);
  for (i=1; i<=3; i++)
  { t = OSSpawn("worker",worker,DEFAULT_STACKSIZE,1,i);
    OSReady(t);
  }
  while (n < 9) OSReschedule();
  order[n] = 0;
  LCDPrintf("%s\n",order);
  printf("order %s, status %d\n",order,OSMTStatus() == COOP);
  return 0;
}
