#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::bridges {

/// Waits until `fd` has one of `events` (poll.h), an error or a hang-up; false when `deadline` came
/// first. With a virtual clock the wait ends at the deadline only, without wall time passing.
bool wait_ready(int fd, short events, Clock& clock, Time deadline);

/// "No such file or directory" for ENOENT.
std::string errno_text(int error);

/// Waits until `ready()`, asked under `lock`, or `deadline`; returns the last answer.
template <class Ready>
bool wait_on(std::condition_variable& changed, std::unique_lock<std::mutex>& lock, Clock& clock,
             Time deadline, Ready ready) {
  constexpr Time kLongest = std::chrono::hours(1);  // now() + more than this may overflow
  while (!ready()) {
    const Time now = clock.now();
    if (now >= deadline) return false;
    if (clock.is_virtual()) {
      lock.unlock();
      clock.wait_until(deadline);
      lock.lock();
    } else {
      changed.wait_for(lock, deadline - now < kLongest ? deadline - now : kLongest);
    }
  }
  return true;
}

}  // namespace eyebridge::bridges
