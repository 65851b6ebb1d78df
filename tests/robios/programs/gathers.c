// What a robot's program does before its first call: "700" sleeps so many milliseconds, "t700" does
// so in a thread, which makes that call; "q700" ends then without one, "s" waits for itself for
// ever. Then it drives, and tells when its first call came and how far it got.
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <eyebot.h>

static void* begin(void* milliseconds) {
  usleep(1000 * (useconds_t)atoi(milliseconds));
  const int at = OSGetCount();
  VWSetSpeed(200, 0);
  OSWait(500);
  int x, y, phi;
  VWGetPosition(&x, &y, &phi);
  printf("%d at %d drove %d\n", OSMachineID(), at, x / 10 * 10);
  return NULL;
}

int main(int argc, char** argv) {
  char* how = argc > 1 ? argv[1] : "0";
  if (*how == 's') {
    pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
    for (;;) pthread_mutex_lock(&mutex);
  }
  if (*how == 'q') {
    usleep(1000 * (useconds_t)atoi(how + 1));
  } else if (*how == 't') {
    pthread_t thread;
    pthread_create(&thread, NULL, begin, how + 1);
    pthread_join(thread, NULL);
  } else {
    begin(how);
  }
  return 0;
}
