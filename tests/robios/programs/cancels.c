/* Threads that are cancelled while they sleep, wait, and have a lock. */
#include "eyebot.h"

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t never = PTHREAD_COND_INITIALIZER;
static pthread_mutex_t twice;

static void unlock(void* held) { pthread_mutex_unlock(held); }

static void* run_on(void* unused) {
  for (;;) usleep(1000);
  return unused;
}

static void* wait_for_ever(void* unused) {
  pthread_mutex_lock(&mutex);
  pthread_cleanup_push(unlock, &mutex);
  for (;;) pthread_cond_wait(&never, &mutex);
  pthread_cleanup_pop(1);
  return unused;
}

static void* keep(void* unused) {
  pthread_mutex_lock(&twice);
  for (;;) OSWait(10);
  return unused;
}

static int cancelled(void* (*start)(void*)) {
  pthread_t thread;
  void* result;
  pthread_create(&thread, NULL, start, NULL);
  OSWait(50);
  pthread_cancel(thread);
  pthread_join(thread, &result);
  return result == PTHREAD_CANCELED;
}

int main() {
  pthread_mutexattr_t attributes;
  int a, b, c, is_free, is_taken;
  OSGetCount();
  a = cancelled(run_on);
  b = cancelled(wait_for_ever);
  is_free = pthread_mutex_trylock(&mutex) == 0;
  pthread_mutexattr_init(&attributes);
  pthread_mutexattr_settype(&attributes, PTHREAD_MUTEX_RECURSIVE);
  pthread_mutex_init(&twice, &attributes);
  c = cancelled(keep);
  is_taken = pthread_mutex_trylock(&twice) != 0;
  printf("%d: cancelled %d%d%d, free %d, taken %d, at %d\n", OSMachineID(), a, b, c, is_free,
         is_taken, OSGetCount());
  return 0;
}
