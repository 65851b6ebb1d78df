#pragma once

#include <cerrno>
#include <chrono>
#include <ctime>

#include <semaphore.h>

namespace eyebridge::robios {

/// What a thread sleeps at until another one wakes it, once for each time.
class WakeUp {
 public:
  WakeUp() { sem_init(&semaphore_, 0, 0); }
  ~WakeUp() { sem_destroy(&semaphore_); }
  WakeUp(const WakeUp&) = delete;
  WakeUp& operator=(const WakeUp&) = delete;

  void post() { sem_post(&semaphore_); }
  /// Returns after `patience` of real time at the latest.
  void wait_for(std::chrono::microseconds patience) {
    timespec until{};
    clock_gettime(CLOCK_MONOTONIC, &until);
    constexpr long kSecond = 1'000'000'000;
    until.tv_nsec += static_cast<long>(patience / std::chrono::nanoseconds(1));
    until.tv_sec += until.tv_nsec / kSecond;
    until.tv_nsec %= kSecond;
    while (sem_clockwait(&semaphore_, CLOCK_MONOTONIC, &until) != 0 && errno == EINTR) {
    }
  }

 private:
  sem_t semaphore_;
};

}  // namespace eyebridge::robios
