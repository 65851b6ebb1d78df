/* Never ends by itself: --time-limit or a signal must end it, motors stopped. */
#include "eyebot.h"

int main() {
  VWSetSpeed(100, 0);
  for (;;) PSDGet(PSD_FRONT);
}
