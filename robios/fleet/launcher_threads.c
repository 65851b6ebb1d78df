/* Threads of robots' programs. In virtual time they take turns in one thread of the process
   (robios/fleet/strands): what would block it lays down the caller instead. In real time a new
   thread only learns whose robot it is. */
#include <errno.h>
#include <limits.h>
#include <pthread.h>
#include <sched.h>
#include <stdlib.h>
#include <time.h>

#include "next.h"

struct beginning {
  void* (*start)(void*);
  void* argument;
  void* robot;
};

static void* begin(void* given) {
  const struct beginning beginning = *(struct beginning*)given;
  free(given);
  CALLS.begin_thread(beginning.robot);
  return beginning.start(beginning.argument);
}

EXPORTED int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                            void* (*start)(void*), void* argument) {
  NEXT(int, pthread_create, (pthread_t*, const pthread_attr_t*, void* (*)(void*), void*));
  if (TAKES_TURNS()) {
    int detached = PTHREAD_CREATE_JOINABLE;
    if (attributes != NULL) pthread_attr_getdetachstate(attributes, &detached);
    *thread = (pthread_t)CALLS.create(start, argument);
    if (detached == PTHREAD_CREATE_DETACHED) CALLS.detach(*thread);
    return 0;
  }
  void* robot = CALLS.robot != NULL ? CALLS.robot() : NULL;
  if (robot == NULL) return next_pthread_create(thread, attributes, start, argument);
  struct beginning* beginning = malloc(sizeof *beginning);
  if (beginning == NULL) {
    CALLS.forget_thread(robot);
    return EAGAIN;
  }
  *beginning = (struct beginning){start, argument, robot};
  const int error = next_pthread_create(thread, attributes, begin, beginning);
  if (error != 0) {
    free(beginning);
    CALLS.forget_thread(robot);
  }
  return error;
}

EXPORTED pthread_t pthread_self(void) {
  NEXT(pthread_t, pthread_self, (void));
  const unsigned long mine = TAKES_TURNS() ? CALLS.self() : 0;
  return mine != 0 ? (pthread_t)mine : next_pthread_self();
}

EXPORTED int pthread_join(pthread_t thread, void** result) {
  NEXT(int, pthread_join, (pthread_t, void**));
  return TAKES_TURNS() ? CALLS.join(thread, result) : next_pthread_join(thread, result);
}

EXPORTED int pthread_detach(pthread_t thread) {
  NEXT(int, pthread_detach, (pthread_t));
  return TAKES_TURNS() ? CALLS.detach(thread) : next_pthread_detach(thread);
}

EXPORTED void pthread_exit(void* result) {
  NEXT(void, pthread_exit, (void*));
  if (CALLS.finish != NULL && (CALLS.robot != NULL || TAKES_TURNS())) CALLS.finish(result);
  next_pthread_exit(result);
  for (;;) pause();
}

EXPORTED int pthread_setname_np(pthread_t thread, const char* name) {
  NEXT(int, pthread_setname_np, (pthread_t, const char*));
  return TAKES_TURNS() ? 0 : next_pthread_setname_np(thread, name);
}

EXPORTED int pthread_cancel(pthread_t thread) {
  NEXT(int, pthread_cancel, (pthread_t));
  return TAKES_TURNS() ? CALLS.cancel(thread) : next_pthread_cancel(thread);
}

/* Keys that programs have made in turns. Others are libraries', also a sanitizer's, which looks at
   any time, and stay the C library's. */
static char is_programs[PTHREAD_KEYS_MAX];

static int is_strands(pthread_key_t key) {
  return key < PTHREAD_KEYS_MAX && is_programs[key] != 0 && TAKES_TURNS();
}

EXPORTED int pthread_key_create(pthread_key_t* key, void (*destroy)(void*)) {
  NEXT(int, pthread_key_create, (pthread_key_t*, void (*)(void*)));
  if (!TAKES_TURNS()) return next_pthread_key_create(key, destroy);
  const int error = next_pthread_key_create(key, NULL); /* only its number is used */
  if (error != 0) return error;
  CALLS.make_key(*key, destroy);
  is_programs[*key] = 1;
  return 0;
}

EXPORTED int pthread_key_delete(pthread_key_t key) {
  NEXT(int, pthread_key_delete, (pthread_key_t));
  if (is_strands(key)) {
    is_programs[key] = 0;
    CALLS.forget_key(key);
  }
  return next_pthread_key_delete(key);
}

EXPORTED void* pthread_getspecific(pthread_key_t key) {
  NEXT(void*, pthread_getspecific, (pthread_key_t));
  return is_strands(key) ? CALLS.specific(key) : next_pthread_getspecific(key);
}

EXPORTED int pthread_setspecific(pthread_key_t key, const void* value) {
  NEXT(int, pthread_setspecific, (pthread_key_t, const void*));
  if (!is_strands(key)) return next_pthread_setspecific(key, value);
  CALLS.set_specific(key, value);
  return 0;
}

EXPORTED int pthread_barrier_init(pthread_barrier_t* barrier,
                                  const pthread_barrierattr_t* attributes, unsigned count) {
  NEXT(int, pthread_barrier_init, (pthread_barrier_t*, const pthread_barrierattr_t*, unsigned));
  const int error = next_pthread_barrier_init(barrier, attributes, count);
  if (error == 0 && TAKES_TURNS()) CALLS.make_barrier(barrier, count);
  return error;
}

EXPORTED int pthread_barrier_destroy(pthread_barrier_t* barrier) {
  NEXT(int, pthread_barrier_destroy, (pthread_barrier_t*));
  if (TAKES_TURNS()) CALLS.make_barrier(barrier, 0);
  return next_pthread_barrier_destroy(barrier);
}

EXPORTED int pthread_barrier_wait(pthread_barrier_t* barrier) {
  NEXT(int, pthread_barrier_wait, (pthread_barrier_t*));
  if (!TAKES_TURNS()) return next_pthread_barrier_wait(barrier);
  return CALLS.meet(barrier) ? PTHREAD_BARRIER_SERIAL_THREAD : 0;
}

EXPORTED int sched_yield(void) {
  NEXT(int, sched_yield, (void));
  if (!TAKES_TURNS()) return next_sched_yield();
  CALLS.park(NULL, CALLS.now() + 1000); /* somebody else's turn, a microsecond long */
  return 0;
}
