/* OSWait, OSGetCount, timers and OSGetTime on the robot's clock. */
#include "eyebot.h"

static int fast_calls, slow_calls, late_calls;
static void fast(void) { fast_calls++; }
static void slow(void) { slow_calls++; }
static void late(void) { late_calls++; }

int main() {
  int before, after, h, m, s, t;
  TIMER a, b;

  before = OSGetCount();
  OSWait(1500);
  after = OSGetCount();
  printf("waited %d\n", after - before);
  a = OSAttachTimer(10, fast);
  b = OSAttachTimer(250, slow);
  printf("handles %s\n", a > 0 && b > 0 && a != b ? "differ" : "wrong");
  OSWait(1005);
  OSDetachTimer(a);
  OSWait(500);
  printf("fast %d slow %d\n", fast_calls, slow_calls);
  OSDetachTimer(b);
  OSAttachTimer(100, late);
  while (late_calls < 5) PSDGet(PSD_FRONT); /* a polling loop lets time pass, too */
  printf("late %d\n", late_calls);
  printf("detach twice %d, bad timer %d\n", OSDetachTimer(a), OSAttachTimer(0, fast));
  OSGetTime(&h, &m, &s, &t);
  printf("time %02d:%02d:%02d\n", h, m, s);
  return 0;
}
