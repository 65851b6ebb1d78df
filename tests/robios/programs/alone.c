/* RADIO with nobody else in the world. */
#include "eyebot.h"

int main() {
  char text[8];
  int ids[256], id = 0, n;

  printf("off %d %d %d\n", RADIOSend(1, "x"), RADIOCheck(), RADIOStatus(ids));
  printf("init %d", RADIOInit());
  printf(" id %d check %d\n", RADIOGetID(), RADIOCheck());
  n = RADIOStatus(ids);
  printf("status %d %d\n", n, ids[0]);
  printf("send %d %d %d %d\n", RADIOSend(1, "hello, world"), RADIOSend(2, "nobody"),
         RADIOSend(0, "x"), RADIOSend(1, NULL));
  printf("check %d", RADIOCheck());
  printf(" %d", RADIOCheck(&id));
  printf(" %d\n", id);
  id = 0;
  n = RADIOReceive(&id, text, sizeof text);
  printf("received %d from %d: %s, check %d\n", n, id, text, RADIOCheck());
  RADIOSend(1, "again");
  printf("bad %d %d\n", RADIOReceive(&id, NULL, 8), RADIOReceive(&id, text, 0));
  n = RADIOReceive(NULL, text, sizeof text);
  printf("without sender %d %s\n", n, text);
  RADIOSend(1, "gone");
  printf("release %d", RADIORelease());
  printf(" init %d", RADIOInit());
  printf(" check %d status %d\n", RADIOCheck(), RADIOStatus(NULL));
  RADIOReceive(&id, text, sizeof text); /* nobody can send any more */
  printf("never\n");
  return 0;
}
