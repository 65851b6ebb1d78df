// It only gives way, for ever.
#include <sched.h>

#include <eyebot.h>

int main(void) {
  OSWait(50);
  for (;;) sched_yield();
}
