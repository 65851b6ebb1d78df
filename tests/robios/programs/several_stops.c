// The second of several robots goes on no further, in the way that the argument names; the others
// take memory and print a second long. One way, "waits", is for a robot that is alone, too.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <eyebot.h>

static volatile unsigned long counter;

static void take_and_give(void) {
  char* volatile one = malloc(5000);
  char* volatile other = malloc(7000);
  free(one);
  free(other);
}

static void spoil_heap(void) {
  char* volatile one = malloc(5000);
  char* volatile other = malloc(5000);
  free(one);
  free(other);
  free(one);
}

static int fill(int depth) {
  volatile char room[4096];
  memset((char*)room, depth, sizeof room);
  return depth < 0 ? 0 : fill(depth + 1) + room[7];
}

static void stop(const char* how) {
  char byte = 0;
  int ends[2] = {0, 0};
  if (strcmp(how, "computes") == 0) {
    for (;;) ++counter;
  } else if (strcmp(how, "takes memory") == 0) {
    for (;;) take_and_give();
  } else if (strcmp(how, "prints") == 0) {
    for (;;) printf("%s", ""), fflush(stdout);
  } else if (strcmp(how, "reads") == 0) {
    if (pipe(ends) == 0 && read(ends[0], &byte, 1) < 0) counter = 1;
  } else if (strcmp(how, "asks") == 0) {
    if (read(STDIN_FILENO, &byte, 1) == 1) printf("2 read %c\n", byte);
  } else if (strcmp(how, "pauses") == 0) {
    pause();
  } else if (strcmp(how, "writes where nothing is") == 0) {
    *(volatile int*)8 = 1;
  } else if (strcmp(how, "uses up its stack") == 0) {
    counter = (unsigned long)fill(0);
  } else if (strcmp(how, "shows no picture") == 0) {
    LCDImage((BYTE*)16);
  } else if (strcmp(how, "prints nothing") == 0) {
    printf("%s", (char*)8); /* standard output is locked */
  } else if (strcmp(how, "spoils its heap") == 0) {
    spoil_heap(); /* the C library ends it with the heap locked */
  }
}

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  OSWait(50);
  if (strcmp(argv[1], "waits") == 0) OSWait(1000 * 1000);
  if (OSMachineID() == 2) stop(argv[1]);
  for (int i = 0; i < 100; ++i) {
    take_and_give();
    printf(".");
    OSWait(10);
  }
  printf("\n%d is at the end\n", OSMachineID());
  fflush(stdout);
  return 0;
}
