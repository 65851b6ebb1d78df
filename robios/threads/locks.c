/* What threads of robots' programs wait for each other with, in virtual time: mutexes, conditions,
   semaphores. All keep their state where the C library has it. */
#include <errno.h>
#include <pthread.h>
#include <semaphore.h>

#include "next.h"
#include "program_threads.h"
#include "robot_time.h"

static int is_checked(const pthread_mutex_t* mutex) {
  return (mutex->__data.__kind & 3) == PTHREAD_MUTEX_ERRORCHECK;
}

static int is_free(const void* mutex, long unused) {
  (void)unused;
  return ((const pthread_mutex_t*)mutex)->__data.__lock == 0;
}

static int has_value(const void* semaphore, long unused) {
  int value = 0;
  (void)unused;
  return sem_getvalue((sem_t*)semaphore, &value) == 0 && value > 0;
}

/* On which clock it counts: bit 1 of what glibc has there. */
static clockid_t clock_of(const pthread_cond_t* condition) {
  return (condition->__data.__wrefs & 2) != 0 ? CLOCK_MONOTONIC : CLOCK_REALTIME;
}

/* 0, EBUSY or EDEADLK. */
static int try_lock(pthread_mutex_t* mutex) {
  NEXT(int, pthread_mutex_trylock, (pthread_mutex_t*));
  if (is_checked(mutex) && mutex->__data.__owner == gettid()) return EDEADLK;
  return next_pthread_mutex_trylock(mutex);
}

static int lock_until(pthread_mutex_t* mutex, long long deadline) {
  for (;;) {
    const int error = try_lock(mutex);
    if (error != EBUSY) return error;
    if (deadline == NO_TIME) return EINVAL;
    if (eyebridge_park_unless(mutex, deadline, is_free, 0, EYEBRIDGE_LIBRARIES)) return ETIMEDOUT;
  }
}

EXPORTED int pthread_mutex_lock(pthread_mutex_t* mutex) {
  NEXT(int, pthread_mutex_lock, (pthread_mutex_t*));
  return eyebridge_takes_turns() ? lock_until(mutex, -1) : next_pthread_mutex_lock(mutex);
}

EXPORTED int pthread_mutex_trylock(pthread_mutex_t* mutex) {
  NEXT(int, pthread_mutex_trylock, (pthread_mutex_t*));
  if (!eyebridge_takes_turns()) return next_pthread_mutex_trylock(mutex);
  const int error = try_lock(mutex);
  return error == EDEADLK ? EBUSY : error;
}

EXPORTED int pthread_mutex_timedlock(pthread_mutex_t* mutex, const struct timespec* until) {
  NEXT(int, pthread_mutex_timedlock, (pthread_mutex_t*, const struct timespec*));
  if (!eyebridge_takes_turns()) return next_pthread_mutex_timedlock(mutex, until);
  return lock_until(mutex, deadline_of(CLOCK_REALTIME, until));
}

EXPORTED int pthread_mutex_clocklock(pthread_mutex_t* mutex, clockid_t clock,
                                     const struct timespec* until) {
  NEXT(int, pthread_mutex_clocklock, (pthread_mutex_t*, clockid_t, const struct timespec*));
  if (!eyebridge_takes_turns()) return next_pthread_mutex_clocklock(mutex, clock, until);
  return lock_until(mutex, deadline_of(clock, until));
}

/* Not by the function's name, behind which a sanitizer may stand. */
static int unlock(pthread_mutex_t* mutex) {
  NEXT(int, pthread_mutex_unlock, (pthread_mutex_t*));
  const int error = next_pthread_mutex_unlock(mutex);
  if (error == 0) eyebridge_wake(mutex, 0);
  return error;
}

EXPORTED int pthread_mutex_unlock(pthread_mutex_t* mutex) {
  NEXT(int, pthread_mutex_unlock, (pthread_mutex_t*));
  return eyebridge_takes_turns() ? unlock(mutex) : next_pthread_mutex_unlock(mutex);
}

/* How often conditions were signalled: who runs beside the others, as it came back from a pipe, may
   do so when somebody has just given the mutex back, and does not wait yet. */
static long signals;

static int was_signalled(const void* condition, long before) {
  (void)condition;
  return __atomic_load_n(&signals, __ATOMIC_SEQ_CST) != before;
}

static int wait_for(pthread_cond_t* condition, pthread_mutex_t* mutex, long long deadline) {
  if (deadline == NO_TIME) return EINVAL;
  const long before = __atomic_load_n(&signals, __ATOMIC_SEQ_CST);
  unlock(mutex);
  const int is_late =
      eyebridge_park_unless(condition, deadline, was_signalled, before, EYEBRIDGE_NOBODY);
  const int error = lock_until(mutex, -1);
  pthread_testcancel(); /* with the mutex */
  return error != 0 ? error : is_late ? ETIMEDOUT : 0;
}

EXPORTED int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex) {
  NEXT(int, pthread_cond_wait, (pthread_cond_t*, pthread_mutex_t*));
  return eyebridge_takes_turns() ? wait_for(condition, mutex, -1)
                                 : next_pthread_cond_wait(condition, mutex);
}

EXPORTED int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                                    const struct timespec* until) {
  NEXT(int, pthread_cond_timedwait, (pthread_cond_t*, pthread_mutex_t*, const struct timespec*));
  if (!eyebridge_takes_turns()) return next_pthread_cond_timedwait(condition, mutex, until);
  return wait_for(condition, mutex, deadline_of(clock_of(condition), until));
}

EXPORTED int pthread_cond_clockwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                                    clockid_t clock, const struct timespec* until) {
  NEXT(int, pthread_cond_clockwait,
       (pthread_cond_t*, pthread_mutex_t*, clockid_t, const struct timespec*));
  if (!eyebridge_takes_turns()) return next_pthread_cond_clockwait(condition, mutex, clock, until);
  return wait_for(condition, mutex, deadline_of(clock, until));
}

EXPORTED int pthread_cond_signal(pthread_cond_t* condition) {
  NEXT(int, pthread_cond_signal, (pthread_cond_t*));
  if (eyebridge_takes_turns()) {
    __atomic_add_fetch(&signals, 1, __ATOMIC_SEQ_CST);
    eyebridge_wake(condition, 0);
  }
  return next_pthread_cond_signal(condition);
}

EXPORTED int pthread_cond_broadcast(pthread_cond_t* condition) {
  NEXT(int, pthread_cond_broadcast, (pthread_cond_t*));
  if (eyebridge_takes_turns()) {
    __atomic_add_fetch(&signals, 1, __ATOMIC_SEQ_CST);
    eyebridge_wake(condition, 1);
  }
  return next_pthread_cond_broadcast(condition);
}

static int take_until(sem_t* semaphore, long long deadline) {
  while (sem_trywait(semaphore) != 0) {
    if (errno != EAGAIN) return -1;
    if (deadline == NO_TIME) {
      errno = EINVAL;
      return -1;
    }
    const int is_late = eyebridge_park_unless(semaphore, deadline, has_value, 0, EYEBRIDGE_ANYBODY);
    pthread_testcancel();
    if (is_late) {
      errno = ETIMEDOUT;
      return -1;
    }
  }
  return 0;
}

EXPORTED int sem_wait(sem_t* semaphore) {
  NEXT(int, sem_wait, (sem_t*));
  return eyebridge_takes_turns() ? take_until(semaphore, -1) : next_sem_wait(semaphore);
}

EXPORTED int sem_timedwait(sem_t* semaphore, const struct timespec* until) {
  NEXT(int, sem_timedwait, (sem_t*, const struct timespec*));
  if (!eyebridge_takes_turns()) return next_sem_timedwait(semaphore, until);
  return take_until(semaphore, deadline_of(CLOCK_REALTIME, until));
}

EXPORTED int sem_clockwait(sem_t* semaphore, clockid_t clock, const struct timespec* until) {
  NEXT(int, sem_clockwait, (sem_t*, clockid_t, const struct timespec*));
  if (!eyebridge_takes_turns()) return next_sem_clockwait(semaphore, clock, until);
  return take_until(semaphore, deadline_of(clock, until));
}

EXPORTED int sem_post(sem_t* semaphore) {
  NEXT(int, sem_post, (sem_t*));
  const int result = next_sem_post(semaphore);
  if (result == 0 && eyebridge_takes_turns()) eyebridge_wake(semaphore, 0);
  return result;
}
