// A program that asks where it is and waits, 100 times a second: hundred_hertz SECONDS.
// `./test scale` times how fast many of them run in virtual time; with "heap N" robot N says,
// instead, how many bytes of heap are in use when all have printed something.
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <eyebot.h>

static void work(int rounds) {
  for (int i = 0; i < rounds; ++i) {
    int x, y, phi;
    VWGetPosition(&x, &y, &phi);  // 1.5 ms of the robot's time
    usleep(8500);
  }
}

static void tell_heap(int robot) {
  LCDPrintf("robot %d\n", OSMachineID());
  OSWait(100);
  if (OSMachineID() == robot) printf("%zu\n", mallinfo2().uordblks);
  OSWait(100);
}

int main(int argc, char** argv) {
  if (argc > 2 && strcmp(argv[1], "heap") == 0) {
    tell_heap(atoi(argv[2]));
  } else {
    work(100 * (argc > 1 ? atoi(argv[1]) : 60));
  }
  return 0;
}
