// How many microseconds of real time a question takes to a program in a process of its own: ask N.
// A program that calls syscall() gets a process of its own.
#include <stdio.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <eyebot.h>

/// Not clock_gettime(): that is the robot's time.
static double real_time(void) {
  struct timespec time = {0, 0};
  syscall(SYS_clock_gettime, CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

int main(int argc, char** argv) {
  const int questions = argc > 1 ? atoi(argv[1]) : 50000;
  if (OSMachineID() != 1) return 0;
  const double begin = real_time();
  for (int i = 0; i < questions; ++i) PSDGet(PSD_FRONT);
  printf("%.2f\n", (real_time() - begin) / questions * 1e6);
  return 0;
}
