/* Waits for a key in two threads until it is stopped; a person may have typed Ctrl-C. */
#include "eyebot.h"

static void* wait(void* unused) {
  for (;;) KEYWait(ANYKEY);
  return unused;
}

int main() {
  pthread_t thread;
  OSWait(200); /* a trace of more than its first line */
  printf("waiting\n");
  fflush(stdout);
  pthread_create(&thread, NULL, wait, NULL);
  wait(NULL);
}
