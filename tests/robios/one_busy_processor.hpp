#pragma once

#include <atomic>
#include <thread>

#include <sched.h>

namespace eyebridge::testing {

/// While it lives this process, and what it starts, run on the first processor only, beside a thread
/// that computes.
class OneBusyProcessor {
 public:
  OneBusyProcessor() {
    sched_getaffinity(0, sizeof before_, &before_);
    cpu_set_t first;
    CPU_ZERO(&first);
    for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&first) == 0; ++cpu) {
      if (CPU_ISSET(cpu, &before_)) CPU_SET(cpu, &first);
    }
    sched_setaffinity(0, sizeof first, &first);
    busy_ = std::thread([this] {
      while (!stop_) {
      }
    });
  }
  ~OneBusyProcessor() {
    stop_ = true;
    busy_.join();
    sched_setaffinity(0, sizeof before_, &before_);
  }
  OneBusyProcessor(const OneBusyProcessor&) = delete;
  OneBusyProcessor& operator=(const OneBusyProcessor&) = delete;

 private:
  cpu_set_t before_{};
  std::atomic<bool> stop_ = false;
  std::thread busy_;
};

}  // namespace eyebridge::testing
