/* A conversation over SERIAL2 with a device that answers seven bytes. */
#include "eyebot.h"
#include "tell.h"

int main() {
  char c = 'n';
  int i, n = 0;
  TELL("bad baud", OSInitRS232(99, NONE, SERIAL2));
  TELL("init", OSInitRS232(SER115200, NONE, SERIAL2));
  TELL("nothing", OSRecvRS232(&c, SERIAL2));
  for (i = 0; i < 6; i++) n += OSSendCharRS232("hello!"[i], SERIAL2);
  n += OSSendRS232(&c, SERIAL2);
  TELL("sent", n);
  for (i = 0; i < 11; i++) {
    n = OSRecvRS232(&c, SERIAL2);
    if (n) break;
    putchar(c);
  }
  printf("\n");
  TELL("last", n);
  TELL("waiting", OSCheckInRS232(SERIAL2));
  TELL("out", OSCheckOutRS232(SERIAL2));
  TELL("flush", OSFlushInRS232(SERIAL2) + OSFlushOutRS232(SERIAL2));
  TELL("null", OSRecvRS232(NULL, SERIAL2));
  return 0;
}
