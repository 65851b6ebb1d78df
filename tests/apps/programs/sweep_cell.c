/* Runs of a sweep, good and bad: drive MS, crash, hang, exit N, nothing. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "eyebot.h"

int main(int argc, char** argv) {
  const char* what = argc > 1 ? argv[1] : "nothing";
  const int number = argc > 2 ? atoi(argv[2]) : 0;
  if (strcmp(what, "nothing") == 0) return 0;
  VWSetSpeed(200, 0);
  if (strcmp(what, "drive") == 0) {
    int x = 0;
    int y = 0;
    int phi = 0;
    printf("result way first\n");
    OSWait(number);
    VWGetPosition(&x, &y, &phi);
    printf("result way %d\nresult word two words\n", x);
    return 0;
  }
  OSWait(2500);
  if (strcmp(what, "crash") == 0) {
    signal(SIGSEGV, SIG_DFL);  // a sanitizer would make it an exit code
    raise(SIGSEGV);
  }
  if (strcmp(what, "exit") == 0) {
    fprintf(stderr, "I give up\n");
    return number;
  }
  for (;;) {
  }
}
