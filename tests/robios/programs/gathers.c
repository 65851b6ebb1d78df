// The argument says what the program does before its first robot call. "700": it sleeps 700 ms.
// "q700": it sleeps 700 ms and ends without a call. In gathers_apart alone, "t700": a thread sleeps
// 700 ms and makes the call; "s": a thread waits for ever. After its first call the program drives,
// and tells when that call came and how far it got.
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

#ifdef APART
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;

static void* wait_for_ever(void* unused) {
  pthread_mutex_lock(&mutex);
  return unused;
}
#endif

int main(int argc, char** argv) {
  char* how = argc > 1 ? argv[1] : "0";
#ifdef APART
  if (*how == 't' || *how == 's') {
    pthread_t thread;
    pthread_mutex_lock(&mutex);
    pthread_create(&thread, NULL, *how == 't' ? begin : wait_for_ever, how + 1);
    pthread_join(thread, NULL);
    return 0;
  }
#endif
  if (*how == 'q') {
    usleep(1000 * (useconds_t)atoi(how + 1));
  } else {
    begin(how);
  }
  return 0;
}
