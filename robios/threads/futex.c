/* futex(2) in virtual time: what C++ waits with in std::atomic::wait(), latches, barriers,
   semaphores and futures, all by syscall(2). */
#include <errno.h>
#include <limits.h>
#include <linux/futex.h>
#include <stdarg.h>
#include <stdint.h>
#include <sys/syscall.h>

#include "next.h"
#include "program_threads.h"
#include "robot_time.h"

/* -1: none. */
static long long end_of(int operation, const struct timespec* timeout) {
  if (timeout == NULL) return NO_DEADLINE;
  if ((operation & FUTEX_CMD_MASK) == FUTEX_WAIT) {
    const long long wait = deadline_of(CLOCK_MONOTONIC, timeout); /* which begins at 0 */
    return wait < 0 ? wait : eyebridge_now() + wait;
  }
  const int is_day = (operation & FUTEX_CLOCK_REALTIME) != 0;
  return deadline_of(is_day ? CLOCK_REALTIME : CLOCK_MONOTONIC, timeout);
}

static int has_changed(const void* word, long value) {
  return __atomic_load_n((const uint32_t*)word, __ATOMIC_SEQ_CST) != (uint32_t)value;
}

static long wait_while(const uint32_t* word, uint32_t value, long long deadline) {
  if (__atomic_load_n(word, __ATOMIC_SEQ_CST) != value) {
    errno = EAGAIN;
    return -1;
  }
  if (deadline == NO_TIME) {
    errno = EINVAL;
    return -1;
  }
  if (!eyebridge_park_unless(word, deadline, has_changed, (long)value, EYEBRIDGE_NOBODY)) return 0;
  errno = ETIMEDOUT;
  return -1;
}

EXPORTED long syscall(long number, ...) {
  NEXT(long, syscall, (long, ...));
  va_list arguments;
  va_start(arguments, number);
  const long a = va_arg(arguments, long);
  const long b = va_arg(arguments, long);
  const long c = va_arg(arguments, long);
  const long d = va_arg(arguments, long);
  const long e = va_arg(arguments, long);
  const long f = va_arg(arguments, long);
  va_end(arguments);
  if (number != SYS_futex || !eyebridge_takes_turns())
    return next_syscall(number, a, b, c, d, e, f);
  /* NOLINTBEGIN(performance-no-int-to-ptr): so the kernel has them, too */
  const int operation = (int)b;
  switch (operation & FUTEX_CMD_MASK) {
    case FUTEX_WAIT:
    case FUTEX_WAIT_BITSET:
      return wait_while((const uint32_t*)a, (uint32_t)c,
                        end_of(operation, (const struct timespec*)d));
    case FUTEX_WAKE:
    case FUTEX_WAKE_BITSET:
      for (long i = 0; c != INT_MAX && i < c; ++i) eyebridge_wake((const void*)a, 0);
      if (c == INT_MAX) eyebridge_wake((const void*)a, 1);
      return next_syscall(number, a, b, c, d, e, f);
    default:
      return next_syscall(number, a, b, c, d, e, f);
  }
  /* NOLINTEND(performance-no-int-to-ptr) */
}
