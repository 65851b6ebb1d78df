/* Drives, and starts itself once meanwhile, as a program of its own. */
#include <stdlib.h>

#include "eyebot.h"

int main(int argc, char** argv) {
  char command[4096];
  VWSetSpeed(100, 0);
  OSWait(500);
  if (argc > 1) return 0; /* the one that was started */
  snprintf(command, sizeof command, "'%s' again", argv[0]);
  if (system(command) != 0) return 3;
  OSWait(500);
  return 0;
}
