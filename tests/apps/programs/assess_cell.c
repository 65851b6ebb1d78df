/* Drives MM straight on and ends with CODE. */
#include <stdlib.h>

#include "eyebot.h"

int main(int argc, char** argv) {
  VWStraight(argc > 1 ? atoi(argv[1]) : 500, 200);
  VWWait();
  return argc > 2 ? atoi(argv[2]) : 0;
}
