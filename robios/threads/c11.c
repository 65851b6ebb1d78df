/* Threads, mutexes and conditions of C11 (threads.h): the C library has them do what those of POSIX
   do, by functions of its own, which nobody else can stand before. Here they call what does. */
#include <errno.h>
#include <pthread.h>
#include <sched.h>
#include <stdint.h>
#include <stdlib.h>
#include <threads.h>
#include <time.h>

#include "next.h"

/* glibc gives a mtx_t and a cnd_t the room of what they are. */
static pthread_mutex_t* posix_mutex(mtx_t* mutex) { return (pthread_mutex_t*)mutex; }
static pthread_cond_t* posix_condition(cnd_t* condition) { return (pthread_cond_t*)condition; }

static int result_of(int error) {
  switch (error) {
    case 0:
      return thrd_success;
    case ENOMEM:
      return thrd_nomem;
    case ETIMEDOUT:
      return thrd_timedout;
    case EBUSY:
      return thrd_busy;
    default:
      return thrd_error;
  }
}

struct start {
  thrd_start_t function;
  void* argument;
};

static void* begin(void* given) {
  const struct start start = *(struct start*)given;
  free(given);
  return (void*)(intptr_t)start.function(start.argument); /* NOLINT(performance-no-int-to-ptr) */
}

EXPORTED int thrd_create(thrd_t* thread, thrd_start_t function, void* argument) {
  struct start* start = malloc(sizeof *start);
  if (start == NULL) return thrd_nomem;
  *start = (struct start){function, argument};
  const int error = pthread_create(thread, NULL, begin, start);
  if (error != 0) free(start);
  return error == EAGAIN ? thrd_nomem : result_of(error);
}

EXPORTED int thrd_join(thrd_t thread, int* result) {
  void* returned = NULL;
  const int error = pthread_join(thread, &returned);
  if (error == 0 && result != NULL) *result = (int)(intptr_t)returned;
  return result_of(error);
}

EXPORTED void thrd_yield(void) { sched_yield(); }

EXPORTED int thrd_sleep(const struct timespec* wanted, struct timespec* left) {
  if (nanosleep(wanted, left) == 0) return 0;
  return errno == EINTR ? -1 : -2;
}

EXPORTED int mtx_lock(mtx_t* mutex) { return result_of(pthread_mutex_lock(posix_mutex(mutex))); }
EXPORTED int mtx_unlock(mtx_t* mutex) {
  return result_of(pthread_mutex_unlock(posix_mutex(mutex)));
}
EXPORTED int mtx_trylock(mtx_t* mutex) {
  return result_of(pthread_mutex_trylock(posix_mutex(mutex)));
}
EXPORTED int mtx_timedlock(mtx_t* mutex, const struct timespec* until) {
  return result_of(pthread_mutex_timedlock(posix_mutex(mutex), until));
}

EXPORTED int cnd_wait(cnd_t* condition, mtx_t* mutex) {
  return result_of(pthread_cond_wait(posix_condition(condition), posix_mutex(mutex)));
}
EXPORTED int cnd_timedwait(cnd_t* condition, mtx_t* mutex, const struct timespec* until) {
  return result_of(pthread_cond_timedwait(posix_condition(condition), posix_mutex(mutex), until));
}
EXPORTED int cnd_signal(cnd_t* condition) {
  return result_of(pthread_cond_signal(posix_condition(condition)));
}
EXPORTED int cnd_broadcast(cnd_t* condition) {
  return result_of(pthread_cond_broadcast(posix_condition(condition)));
}
