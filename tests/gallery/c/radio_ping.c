/* ping pong by radio; alone on the field the robot plays with itself */
#include "eyebot.h"
#define MAX 100

int main()
{
  int me, partner, total, i, from, len, list[256];
  char buf[MAX];

  RADIOInit();
  me = RADIOGetID();
  partner = me;
  total = RADIOStatus(list);
  LCDPrintf("I am %d, %d robots\n", me, total);
  for (i = 0; i < total; i++) if (list[i] != me) partner = list[i];
  printf("%d robots, partner is %s\n", total, partner == me ? "myself" : "another");
  RADIOSend(partner, "A");
  for (i = 0; i < 10; i++)
  {
    len = RADIOReceive(&from, buf, MAX);
    LCDPrintf("from %d: %s (%d)\n", from, buf, len);
    buf[0]++;
    OSWait(100);
    RADIOSend(from, buf);
  }
  printf("ended with %c, %d waiting\n", buf[0], RADIOCheck());
  RADIOSend(99, "is anybody there?");
  RADIOReceive(&from, buf, MAX);
  printf("last %s, then %d waiting\n", buf, RADIOCheck());
  RADIORelease();
  return 0;
}
