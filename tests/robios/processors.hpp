#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include <sched.h>

namespace eyebridge::testing {

/// On how many processors this process, and what it starts, run while it lives: on the first one or
/// on all; each of them with a thread that computes besides, or without.
class Processors {
 public:
  enum class Which { First, All };
  enum class Load { None, Busy };

  Processors(Which which, Load load) {
    sched_getaffinity(0, sizeof before_, &before_);
    cpu_set_t used = before_;
    if (which == Which::First) {
      CPU_ZERO(&used);
      for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&used) == 0; ++cpu) {
        if (CPU_ISSET(cpu, &before_)) CPU_SET(cpu, &used);
      }
      sched_setaffinity(0, sizeof used, &used);
    }
    if (load == Load::None) return;
    for (int i = 0; i < CPU_COUNT(&used); ++i) {
      busy_.emplace_back([this] {
        while (!stop_) {
        }
      });
    }
  }
  ~Processors() {
    stop_ = true;
    for (std::thread& thread : busy_) thread.join();
    sched_setaffinity(0, sizeof before_, &before_);
  }
  Processors(const Processors&) = delete;
  Processors& operator=(const Processors&) = delete;

 private:
  cpu_set_t before_{};
  std::atomic<bool> stop_ = false;
  std::vector<std::thread> busy_;
};

/// The first processor, and a thread that computes.
class OneBusyProcessor : public Processors {
 public:
  OneBusyProcessor() : Processors(Which::First, Load::Busy) {}
};

}  // namespace eyebridge::testing
