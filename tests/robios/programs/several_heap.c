/* The last robot says how much heap is in use when all are there; each has printed something. */
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>

#include <eyebot.h>

int main(void) {
  LCDPrintf("robot %d\n", OSMachineID());
  OSWait(100);
  if (OSMachineID() == atoi(getenv("EYEBRIDGE_ROBOTS"))) {
    /* Screens have a mapping of their own, of which only what was drawn in is there. */
    printf("%zu\n", mallinfo2().uordblks);
  }
  OSWait(100);
  return 0;
}
