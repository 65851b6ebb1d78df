/* two timers and a main that only waits */
#include "eyebot.h"

int count = 0;      /* not volatile, nobody told us */
int blink = 0;
int last = 0;

void tick() { count++; }

void blinker(void)
{ blink = !blink;
  LCDArea(100, 100, 150, 150, blink ? RED : DARKGRAY, 1);
  LCDSetPrintf(1, 0, "count %4d", count);
}

int main()
{ TIMER t1, t2;
  int hrs, mins, secs, ticks;

  t1 = OSAttachTimer(10, tick);
  t2 = OSAttachTimer(500, &blinker);
  while (count < 300) OSWait(10);
  printf("300 ticks took %d ms\n", OSGetCount() / 100 * 100);
  OSDetachTimer(t1);
  last = count;
  OSWait(1000);
  printf("after detach: %s\n", last == count ? "stands" : "runs");
  t1 = OSAttachTimer(100, tick);
  while (count < 320) { if (KEYRead() == KEY4) break; }
  OSDetachTimer(t1);
  OSDetachTimer(t2);
  OSGetTime(&hrs, &mins, &secs, &ticks);
  printf("count %d, time %02d:%02d:%02d\n", count, hrs, mins, secs);
  printf("detach again %d\n", OSDetachTimer(t2));
  LCDSetPrintf(3, 0, "done");
  return 0;
}
