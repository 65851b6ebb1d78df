// A thread that waits in an empty loop for what another one sets.
#include <pthread.h>
#include <stdio.h>

#include <eyebot.h>

static volatile int enabled = 0;
static volatile int running = 1;
static volatile int count = 0;

static void* worker(void* unused) {
  while (running) {
    if (!enabled) continue;
    LCDPrintf("x");
    ++count;
  }
  return unused;
}

int main(void) {
  pthread_t thread;
  pthread_create(&thread, NULL, worker, NULL);
  for (int i = 0; i < 10; ++i) {
    enabled = 1;
    OSWait(100);
    enabled = 0;
    OSWait(100);
  }
  running = 0;
  pthread_join(thread, NULL);
  printf("%s at %d ms\n", count > 0 ? "counted" : "nothing", OSGetCount());
  return 0;
}
