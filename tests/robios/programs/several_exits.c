// Several robots that end by what would end a process at once, while the last one goes on.
#define _GNU_SOURCE
#include <err.h>
#include <error.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <eyebot.h>

static void hurry(void) {
  OSWait(1);
  printf("robot %d hurries\n", OSMachineID());
}

static void stay(void) { printf("robot %d says goodbye\n", OSMachineID()); }

int main(void) {
  const int id = OSMachineID();
  atexit(stay);
  at_quick_exit(hurry);
  OSWait(100 * id);
  printf("robot %d goes\n", id);
  if (id == 1) _exit(3);
  if (id == 2) _Exit(4);
  if (id == 3) quick_exit(5);
  if (id == 4) errx(6, "trouble");
  if (id == 5) error(7, 0, "more trouble");
  if (id == 6) exit(256);
  OSWait(1000);
  return 0;
}
