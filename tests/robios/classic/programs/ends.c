/* The ends that a program can make: its argument says which. */
#include <string.h>

#include "eyebot.h"

void falls_off() { printf("task\n"); }
void exits() { OSExit(3); }

int main(int argc, char** argv) {
  const char* how = argc > 1 ? argv[1] : "";
  if (!strcmp(how, "panic")) OSPanic("no way");
  if (!strcmp(how, "error")) OSError("dead", 5, TRUE);
  if (!strcmp(how, "key")) printf("error %d\n", OSError("wait", 5, FALSE));
  if (!strcmp(how, "exit")) OSExit(7);
  if (!strcmp(how, "kill")) OSKill(0);
  OSMTInit(COOP);
  OSReady(OSSpawn("falls", falls_off, 4096, MIN_PRI, 1));
  OSReady(OSSpawn("exits", exits, 4096, MIN_PRI, 2));
  OSReschedule();
  printf("main goes on\n");
  if (!strcmp(how, "stuck")) OSSuspend(0);
  return 0;
}
