/* Threads of one of several robots: data of their own, barriers. */
#include "eyebot.h"

static pthread_key_t key;
static pthread_barrier_t barrier;
static int destroyed;

static void destroy(void* value) { destroyed += (int)(long)value; }

static void* keep(void* value) {
  pthread_setspecific(key, value);
  OSWait(100);
  return pthread_getspecific(key);
}

static void* meet(void* wait) {
  OSWait((int)(long)wait);
  return (void*)(long)(pthread_barrier_wait(&barrier) == PTHREAD_BARRIER_SERIAL_THREAD);
}

int main() {
  pthread_t a, b;
  void *of_a, *of_b, *last_a, *last_b;
  int first, met;
  pthread_key_create(&key, destroy);
  pthread_create(&a, NULL, keep, (void*)1L);
  pthread_create(&b, NULL, keep, (void*)2L);
  OSWait(50);
  first = pthread_getspecific(key) == NULL;
  pthread_join(a, &of_a);
  pthread_join(b, &of_b);
  pthread_barrier_init(&barrier, NULL, 3);
  pthread_create(&a, NULL, meet, (void*)10L);
  pthread_create(&b, NULL, meet, (void*)30L);
  pthread_barrier_wait(&barrier);
  met = OSGetCount();
  pthread_join(a, &last_a);
  pthread_join(b, &last_b);
  pthread_barrier_destroy(&barrier);
  printf("%d: mine %d, of a %ld, of b %ld, destroyed %d, ", OSMachineID(), first, (long)of_a,
         (long)of_b, destroyed);
  printf("met at %d, last %ld%ld, at %d\n", met, (long)last_a, (long)last_b, OSGetCount());
  return 0;
}
