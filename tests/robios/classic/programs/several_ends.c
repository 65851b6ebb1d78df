/* Robots whose programs and tasks end in every way; the last one goes on. A crash is for those with
   processes of their own. */
#include <stdlib.h>

#include "eyebot.h"

struct sem never;

void waits() { OSSemP(&never); }
void crashes() {
  OSSleep(5);
  *(volatile int*)8 = 1;
}
int fill(int depth) {
  volatile char room[4096];
  room[depth & 4095] = 1;
  return depth < 0 ? 0 : fill(depth + 1) + room[7];
}
void overflows() { fill(0); }
void exits() { OSExit(3); }

int main() {
  int id = OSMachineID();
  int may_crash = getenv("EYEBRIDGE_ISOLATE") != 0;
  OSWait(10 * id);
  OSSemInit(&never, 0);
  if (id == 1) OSExit(5);
  OSMTInit(COOP);
  if (id == 2) waits();
  if (id == 3) OSPanic("no way");
  if (id == 4 && may_crash) OSReady(OSSpawn("crashes", crashes, 4096, MIN_PRI, 1));
  if (id == 5 && may_crash) OSReady(OSSpawn("overflows", overflows, 4096, MIN_PRI, 1));
  if (id == 6) OSReady(OSSpawn("exits", exits, 4096, MIN_PRI, 1)); /* only the task */
  OSSleep(100);
  printf("robot %d is left\n", id);
  return 0;
}
