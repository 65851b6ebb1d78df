/* A hundred timers at once, and OSWait beside them as long as it says. */
#include "eyebot.h"

#define TIMERS 100
static int calls, quick;
static void count(void) { calls++; }
static void often(void) { quick++; }

int main() {
  TIMER timer[TIMERS];
  int i, before, waited;

  for (i = 0; i < TIMERS; i++) timer[i] = OSAttachTimer(20, count);
  OSAttachTimer(1, often);
  calls = quick = 0;
  before = OSGetCount();
  for (i = 0; i < 10; i++) OSWait(100);
  waited = OSGetCount() - before;
  printf("quick %d\n", quick);
  for (i = 0; i < TIMERS; i++) OSDetachTimer(timer[i]);
  printf("waited %d\n", waited);
  printf("calls %d\n", calls);
  return 0;
}
