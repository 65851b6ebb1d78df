/* Ticks, timers, the clock. */
#include "eyebot.h"

int fast = 0, slow = 0;
void tick() { fast++; }
void tock() { slow++; }

int main()
{ int h = -1, m = -1, s = -1, t = -1, i, day, month, year;
  TimerHandle a, b, last = 1;

  printf("count %d\n", OSGetCount());
  OSWait(150);
  printf("count %d\n", OSGetCount());
  OSSleep(50);
  printf("count %d\n", OSGetCount());
  OSSleepms(250);
  OSGetTime(&h, &m, &s, &t);
  printf("time %d:%d:%d.%d\n", h, m, s, t);
  printf("set %d %d\n", OSSetTime(23, 59, 59), OSSetTime(24, 0, 0));
  OSWait(200);
  OSGetTime(&h, &m, &s, &t);
  OSShowTime();
  printf("time %d:%d:%d\n", h, m, s);
  a = OSAttachTimer(1, tick);
  b = OSAttachTimer(10, tock);
  OSWait(100);
  printf("fast %d slow %d\n", fast, slow);
  OSDisable();
  OSWait(50);
  i = fast;
  OSEnable();
  OSWait(1);
  printf("held %d, then %d\n", i == 100, fast > i);
  printf("detach %d %d %d\n", OSDetachTimer(a), OSDetachTimer(a), OSDetachTimer(b));
  printf("bad %d %d\n", OSAttachTimer(0, tick), OSAttachTimer(1, NULL));
  for (i = 0; last != 0; i++) last = OSAttachTimer(1000, tick);
  printf("timers %d\n", i - 1);
  OSGetDate(&day, &month, &year);
  printf("date %d.%d.%d, set %d %d\n", day, month, year, OSSetDate(29, 2, 2004),
         OSSetDate(29, 2, 2005));
  return 0;
}
