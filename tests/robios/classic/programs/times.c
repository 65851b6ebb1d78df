/* Ticks, timers, the clock. */
#include "eyebot.h"
#include "tell.h"

int fast = 0, slow = 0;
void tick() { fast++; }
void tock() { slow++; }

int main() {
  int h = -1, m = -1, s = -1, t = -1, i, day, month, year;
  TimerHandle a, b, last = 1;

  TELL("count", OSGetCount());
  OSWait(150);
  TELL("count", OSGetCount());
  OSSleep(50);
  TELL("count", OSGetCount());
  OSSleepms(250);
  OSGetTime(&h, &m, &s, &t);
  printf("time %d:%d:%d.%d\n", h, m, s, t);
  TELL("set", OSSetTime(23, 59, 59));
  TELL("no time", OSSetTime(24, 0, 0));
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
  TELL("detach", OSDetachTimer(a));
  TELL("again", OSDetachTimer(a));
  TELL("detach", OSDetachTimer(b));
  TELL("bad", OSAttachTimer(0, tick));
  TELL("bad", OSAttachTimer(1, NULL));
  for (i = 0; last != 0; i++) last = OSAttachTimer(1000, tick);
  TELL("timers", i - 1);
  OSGetDate(&day, &month, &year);
  printf("date %d.%d.%d\n", day, month, year);
  TELL("leap year", OSSetDate(29, 2, 2004));
  TELL("no date", OSSetDate(29, 2, 2005));
  return 0;
}
