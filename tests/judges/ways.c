/* A robot program that drives and ends in the way that its argument names, its motors running. */
#define _ISOC11_SOURCE /* quick_exit() */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "eyebot.h"

static int overflow(volatile char* caller) {
  volatile char page[4096];
  page[0] = (char)(caller[0] + 1);
  return overflow(page) + page[1];
}

static void end(const char* way) {
  if (strcmp(way, "return") == 0) return;
  if (strcmp(way, "exit") == 0) exit(0);
  if (strcmp(way, "_exit") == 0) _exit(0);
  if (strcmp(way, "quick_exit") == 0) quick_exit(0);
  if (strcmp(way, "abort") == 0) abort();
  if (strcmp(way, "segv") == 0) *(volatile int*)NULL = 1;
  if (strcmp(way, "overflow") == 0) exit(overflow((volatile char*)way));
  if (strcmp(way, "exec") == 0) execl("/bin/true", "true", (char*)NULL);
  if (strcmp(way, "fork") == 0 && fork() != 0) _exit(0); /* the child lives on, and waits below */
  for (;;) pause();                                      /* for a signal */
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  int v = 0, w = 0;
  VWSetSpeed(200, 0);
  OSWait(200);
  while (v == 0 && VWGetSpeed(&v, &w) == 0) OSWait(20); /* on a busy computer */
  puts("drives");
  fflush(stdout);
  if (getchar() == EOF) return 2; /* a line: it is time */
  end(argv[1]);
  return 0;
}
