/* The C library's clocks on a robot's: the time of day begins at midnight of the first of January
   2000, UTC, so that runs repeat. */
#ifndef EYEBRIDGE_THREADS_ROBOT_TIME_H
#define EYEBRIDGE_THREADS_ROBOT_TIME_H

#include <time.h>

#define FIRST_SECOND 946684800LL /* of the year 2000, after 1970 */
#define NANOSECONDS 1000000000LL

/* Seconds from the robot's time to that of `clock`. */
static inline long long first_second_of(clockid_t clock) {
  return clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE || clock == CLOCK_TAI
             ? FIRST_SECOND
             : 0;
}

#define NO_DEADLINE (-1LL)
#define NO_TIME (-2LL)            /* what is no time, as POSIX has it: EINVAL for who would wait */
#define MOST_SECONDS 3153600000LL /* a hundred years; whoever waits longer waits for ever */

/* `until` on `clock` as nanoseconds of the robot's time; 0 for what is over before it began. */
static inline long long deadline_of(clockid_t clock, const struct timespec* until) {
  if (until->tv_nsec < 0 || until->tv_nsec >= NANOSECONDS) return NO_TIME;
  const long long first = first_second_of(clock);
  if (until->tv_sec < first) return 0;
  if (until->tv_sec - first > MOST_SECONDS) return NO_DEADLINE;
  return ((long long)until->tv_sec - first) * NANOSECONDS + until->tv_nsec;
}

#endif
