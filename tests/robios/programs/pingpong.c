/* Two of these play: robot 1 begins, 10 times there and back. */
#include "eyebot.h"

int main() {
  char text[100];
  int me, other, id, i, ids[256];

  RADIOInit();
  me = RADIOGetID();
  other = 3 - me;
  while (RADIOStatus(ids) < 2) OSWait(10);
  for (i = 1; i <= 10; i++) {
    if (me == 1) {
      sprintf(text, "ping %d", i);
      RADIOSend(other, text);
    }
    RADIOReceive(&id, text, sizeof text);
    printf("%d: %s\n", id, text);
    if (me == 2) {
      sprintf(text, "pong %d", i);
      RADIOSend(id, text);
    }
  }
  OSWait(200); /* what was sent last has to leave */
  return 0;
}
