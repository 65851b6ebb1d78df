/* ends HOW: the ways a program may end while it drives and other threads call on. */
#include "eyebot.h"

static void* poll(void* unused) {
  (void)unused;
  for (;;) PSDGet(PSD_FRONT);
  return NULL;
}

static void leave(void) { exit(7); }

static void after(void) { printf("late call %d\n", VWSetSpeed(100, 0)); }

int main() {
  const char* how = getenv("EYEBRIDGE_TEST_HOW");
  pthread_t a, b;

  atexit(after); /* runs after the library's own */
  VWSetSpeed(100, 0);
  pthread_create(&a, NULL, poll, NULL);
  pthread_create(&b, NULL, poll, NULL);
  OSWait(300);
  if (strcmp(how, "return") == 0) return 5;
  if (strcmp(how, "timer") == 0) OSAttachTimer(10, leave);
  if (strcmp(how, "signal") == 0) kill(getpid(), SIGTERM);
  for (;;) {
    if (strcmp(how, "idle") == 0) pause();
    OSWait(1);
  }
}
