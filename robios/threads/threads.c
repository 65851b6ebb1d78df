/* Threads of the program of a process's only robot: in virtual time they take turns
   (thread_turns.hpp). They are threads of the system; what is here tells when they come, end, and
   wait for each other's end. */
#include <errno.h>
#include <pthread.h>
#include <sched.h>
#include <stdlib.h>

#include "next.h"
#include "program_threads.h"
#include "robot_time.h"

struct beginning {
  void* (*start)(void*);
  void* argument;
  void* member;
};

static void* begin(void* given) {
  const struct beginning beginning = *(struct beginning*)given;
  free(given);
  eyebridge_thread_starts(beginning.member);
  return beginning.start(beginning.argument);
}

EXPORTED int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                            void* (*start)(void*), void* argument) {
  NEXT(int, pthread_create, (pthread_t*, const pthread_attr_t*, void* (*)(void*), void*));
  /* The thread sanitizer stands before us, and its threads must not begin with code of ours: they
     take turns from their first call on. */
  if (!eyebridge_is_in_program() || dlsym(RTLD_DEFAULT, "__tsan_init") != NULL) {
    return next_pthread_create(thread, attributes, start, argument);
  }
  /* Else threads would run beside each other, and time pass for each by itself, until one calls. */
  eyebridge_begin_time();
  struct beginning* beginning = malloc(sizeof *beginning);
  if (beginning == NULL) return EAGAIN;
  void* const member = eyebridge_thread_expected();
  *beginning = (struct beginning){start, argument, member};
  const int error = next_pthread_create(thread, attributes, begin, beginning);
  if (error == 0) {
    eyebridge_thread_is(member, *thread);
  } else {
    free(beginning);
    eyebridge_thread_failed(member);
  }
  return error;
}

/* One that takes no turns: it has to be looked after. */
static int join_other_until(pthread_t thread, void** result, long long deadline) {
  int error = 0;
  while ((error = pthread_tryjoin_np(thread, result)) == EBUSY) {
    if (eyebridge_now() >= deadline) return ETIMEDOUT;
    eyebridge_park(NULL, eyebridge_now() + NANOSECONDS / 1000);
  }
  return error;
}

typedef int join_function(pthread_t, void**);

static int join_until(pthread_t thread, void** result, long long deadline, join_function* join) {
  if (deadline == NO_TIME) return EINVAL;
  const int is_over = eyebridge_thread_awaited(thread, deadline);
  if (is_over < 0) return ETIMEDOUT;
  if (!is_over && deadline != NO_DEADLINE) return join_other_until(thread, result, deadline);
  /* The kernel's part of its end may still be to come. */
  if (is_over) eyebridge_hold_turn();
  const int error = join(thread, result);
  if (is_over) eyebridge_release_turn();
  return error;
}

static int is_awaited_in_turn(pthread_t thread) {
  return eyebridge_takes_turns() && !pthread_equal(thread, pthread_self());
}

EXPORTED int pthread_join(pthread_t thread, void** result) {
  NEXT(int, pthread_join, (pthread_t, void**));
  return is_awaited_in_turn(thread) ? join_until(thread, result, NO_DEADLINE, next_pthread_join)
                                    : next_pthread_join(thread, result);
}

EXPORTED int pthread_clockjoin_np(pthread_t thread, void** result, clockid_t clock,
                                  const struct timespec* until) {
  NEXT(int, pthread_clockjoin_np, (pthread_t, void**, clockid_t, const struct timespec*));
  NEXT(int, pthread_join, (pthread_t, void**));
  if (until == NULL) return pthread_join(thread, result);
  if (!is_awaited_in_turn(thread)) return next_pthread_clockjoin_np(thread, result, clock, until);
  return join_until(thread, result, deadline_of(clock, until), next_pthread_join);
}

EXPORTED int pthread_timedjoin_np(pthread_t thread, void** result, const struct timespec* until) {
  return pthread_clockjoin_np(thread, result, CLOCK_REALTIME, until);
}

EXPORTED int pthread_cancel(pthread_t thread) {
  NEXT(int, pthread_cancel, (pthread_t));
  const int error = next_pthread_cancel(thread);
  if (error == 0 && eyebridge_takes_turns()) eyebridge_thread_cancelled(thread);
  return error;
}

EXPORTED int pthread_barrier_wait(pthread_barrier_t* barrier) {
  NEXT(int, pthread_barrier_wait, (pthread_barrier_t*));
  const int result = next_pthread_barrier_wait(barrier);
  if (eyebridge_takes_turns())
    eyebridge_park(NULL, 0); /* the thread that came last goes on first */
  return result;
}

EXPORTED int sched_yield(void) {
  NEXT(int, sched_yield, (void));
  if (!eyebridge_takes_turns()) return next_sched_yield();
  eyebridge_park(NULL, eyebridge_now() + 1000); /* somebody else's turn, a microsecond long */
  return 0;
}
