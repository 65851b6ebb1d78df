/* The C library's clocks for robots' programs in virtual time: their robot's. */
#include <errno.h>
#include <sys/time.h>
#include <time.h>

#include "next.h"
#include "program_threads.h"
#include "robot_time.h"

EXPORTED int clock_gettime(clockid_t clock, struct timespec* out) {
  NEXT(int, clock_gettime, (clockid_t, struct timespec*));
  const long long now = eyebridge_read_clock();
  if (now < 0) return next_clock_gettime(clock, out);
  out->tv_sec = (time_t)(now / NANOSECONDS + first_second_of(clock));
  out->tv_nsec = (long)(now % NANOSECONDS);
  return 0;
}

EXPORTED time_t time(time_t* out) {
  NEXT(time_t, time, (time_t*));
  const long long now = eyebridge_read_clock();
  if (now < 0) return next_time(out);
  const time_t seconds = (time_t)(now / NANOSECONDS + FIRST_SECOND);
  if (out != NULL) *out = seconds;
  return seconds;
}

EXPORTED int gettimeofday(struct timeval* out, void* zone) {
  NEXT(int, gettimeofday, (struct timeval*, void*));
  const long long now = eyebridge_read_clock();
  if (now < 0) return next_gettimeofday(out, zone);
  out->tv_sec = (time_t)(now / NANOSECONDS + FIRST_SECOND);
  out->tv_usec = (suseconds_t)(now % NANOSECONDS / 1000);
  return 0;
}

EXPORTED int timespec_get(struct timespec* out, int base) {
  NEXT(int, timespec_get, (struct timespec*, int));
  const int is_robots = base == TIME_UTC && eyebridge_read_clock() >= 0;
  return is_robots && clock_gettime(CLOCK_REALTIME, out) == 0 ? base : next_timespec_get(out, base);
}

EXPORTED clock_t clock(void) {
  NEXT(clock_t, clock, (void));
  const long long now = eyebridge_read_clock();
  return now < 0 ? next_clock() : (clock_t)(now / (NANOSECONDS / CLOCKS_PER_SEC));
}
