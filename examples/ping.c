/* Sends a number to and fro between two robots by radio. Start it twice, each with a number of its
 * own:
 *
 *   eyebridge run --radio 'udp:239.192.7.1:7007?id=1' ping
 *   eyebridge run --radio 'udp:239.192.7.1:7007?id=2' ping
 */
#include "eyebot.h"

int main() {
  int ids[256], me, other, sender, i, count = 0;
  char text[32];

  RADIOInit();
  me = RADIOGetID();
  LCDPrintf("I am robot %d\n", me);
  while (RADIOStatus(ids) < 2) OSWait(100); /* until the other one is there */
  other = ids[0] == me ? ids[1] : ids[0];

  if (me < other) RADIOSend(other, "1"); /* the lower number begins */
  for (i = 0; i < 10; i++) {
    RADIOReceive(&sender, text, sizeof text);
    count = atoi(text);
    LCDPrintf("%d from robot %d\n", count, sender);
    sprintf(text, "%d", count + 1);
    RADIOSend(sender, text);
    OSWait(200);
  }
  printf("robot %d counted to %d\n", me, count);
  RADIORelease();
  return 0;
}
