#pragma once

#include <ctime>

namespace eyebridge::bench {

/// CPU time of this process, seconds.
inline double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// How fast this computer is now, as a multiple of the one on which the peers were measured.
///
/// Both ran one small program: 1,000 objects with a virtual step of a differential drive, sine and
/// cosine of libm, -O2; there it did 76 million steps a CPU second (limits.md of this project's
/// reference data, section 3). Takes about 30 ms.
double computer_speed();

}  // namespace eyebridge::bench
