/* Locks of readers and writers, as locks.c. They keep their state where the C library has it. */
#include <errno.h>
#include <pthread.h>

#include "next.h"
#include "program_threads.h"
#include "robot_time.h"

typedef int try_function(pthread_rwlock_t*);

/* glibc's word for who has it. */
static long state_of(const void* lock) {
  return (long)__atomic_load_n(&((const pthread_rwlock_t*)lock)->__data.__readers,
                               __ATOMIC_SEQ_CST);
}

static int has_changed(const void* lock, long state) { return state_of(lock) != state; }

static int lock_until(pthread_rwlock_t* lock, try_function* attempt, long long deadline) {
  if (lock->__data.__cur_writer == gettid()) return EDEADLK;
  for (;;) {
    const long state = state_of(lock);
    const int error = attempt(lock);
    if (error != EBUSY) return error;
    if (deadline == NO_TIME) return EINVAL;
    if (eyebridge_park_unless(lock, deadline, has_changed, state, EYEBRIDGE_NOBODY))
      return ETIMEDOUT;
  }
}

static int read_until(pthread_rwlock_t* lock, long long deadline) {
  NEXT(int, pthread_rwlock_tryrdlock, (pthread_rwlock_t*));
  return lock_until(lock, next_pthread_rwlock_tryrdlock, deadline);
}

static int write_until(pthread_rwlock_t* lock, long long deadline) {
  NEXT(int, pthread_rwlock_trywrlock, (pthread_rwlock_t*));
  return lock_until(lock, next_pthread_rwlock_trywrlock, deadline);
}

EXPORTED int pthread_rwlock_rdlock(pthread_rwlock_t* lock) {
  NEXT(int, pthread_rwlock_rdlock, (pthread_rwlock_t*));
  return eyebridge_takes_turns() ? read_until(lock, -1) : next_pthread_rwlock_rdlock(lock);
}

EXPORTED int pthread_rwlock_wrlock(pthread_rwlock_t* lock) {
  NEXT(int, pthread_rwlock_wrlock, (pthread_rwlock_t*));
  return eyebridge_takes_turns() ? write_until(lock, -1) : next_pthread_rwlock_wrlock(lock);
}

EXPORTED int pthread_rwlock_timedrdlock(pthread_rwlock_t* lock, const struct timespec* until) {
  NEXT(int, pthread_rwlock_timedrdlock, (pthread_rwlock_t*, const struct timespec*));
  if (!eyebridge_takes_turns()) return next_pthread_rwlock_timedrdlock(lock, until);
  return read_until(lock, deadline_of(CLOCK_REALTIME, until));
}

EXPORTED int pthread_rwlock_timedwrlock(pthread_rwlock_t* lock, const struct timespec* until) {
  NEXT(int, pthread_rwlock_timedwrlock, (pthread_rwlock_t*, const struct timespec*));
  if (!eyebridge_takes_turns()) return next_pthread_rwlock_timedwrlock(lock, until);
  return write_until(lock, deadline_of(CLOCK_REALTIME, until));
}

EXPORTED int pthread_rwlock_clockrdlock(pthread_rwlock_t* lock, clockid_t clock,
                                        const struct timespec* until) {
  NEXT(int, pthread_rwlock_clockrdlock, (pthread_rwlock_t*, clockid_t, const struct timespec*));
  if (!eyebridge_takes_turns()) return next_pthread_rwlock_clockrdlock(lock, clock, until);
  return read_until(lock, deadline_of(clock, until));
}

EXPORTED int pthread_rwlock_clockwrlock(pthread_rwlock_t* lock, clockid_t clock,
                                        const struct timespec* until) {
  NEXT(int, pthread_rwlock_clockwrlock, (pthread_rwlock_t*, clockid_t, const struct timespec*));
  if (!eyebridge_takes_turns()) return next_pthread_rwlock_clockwrlock(lock, clock, until);
  return write_until(lock, deadline_of(clock, until));
}

EXPORTED int pthread_rwlock_unlock(pthread_rwlock_t* lock) {
  NEXT(int, pthread_rwlock_unlock, (pthread_rwlock_t*));
  const int error = next_pthread_rwlock_unlock(lock);
  if (error == 0 && eyebridge_takes_turns()) eyebridge_wake(lock, 1);
  return error;
}
