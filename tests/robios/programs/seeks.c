/* Turns by 10 degrees until the front is farther away than it can be: without errors, for ever. */
#include "eyebot.h"

int main() {
  while (PSDGet(PSD_FRONT) < 5000) {
    VWTurn(10, 90);
    VWWait();
    OSWait(500);
  }
  return 0;
}
