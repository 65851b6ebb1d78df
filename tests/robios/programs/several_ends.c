// Robots that end in every way there is, while the last one goes on. A crash is for those with
// processes of their own.
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <eyebot.h>

static int fill(int depth) {
  volatile char room[4096];
  memset((char*)room, depth, sizeof room);
  return depth < 0 ? 0 : fill(depth + 1) + room[7];
}

int main(void) {
  const int id = OSMachineID();
  OSWait(100 * id);
  if (id == 1) return 3;
  if (id == 2) exit(4);
  if (id == 3) abort();
  if (id == 4) raise(SIGFPE);
  const int may_crash = getenv("EYEBRIDGE_ISOLATE") != NULL;
  if (id == 5 && may_crash) *(volatile int*)8 = 1;
  if (id == 6 && may_crash) return fill(0);
  if (id == 7 && may_crash) LCDImage((BYTE*)16);
  OSWait(1000);
  if (id == 8) printf("robot %d is left\n", id);
  return 0;
}
