#pragma once

#include <functional>
#include <string>

namespace eyebridge {

/// How urgent a thread is for the system.
struct ThreadPriority {
  enum class Kind { RealTime, Nice, Ordinary };

  Kind kind = Kind::Ordinary;
  int level = 0;  ///< Of real-time priorities, or the nice value.

  /// "real-time priority 1", "nice -10", "ordinary priority".
  [[nodiscard]] std::string str() const;
};

/// What is asked of the system for the calling thread: true when it grants it.
struct PriorityCalls {
  std::function<bool(int level)> real_time;  ///< SCHED_RR; threads that it makes are ordinary ones.
  std::function<bool(int level)> nice;

  static PriorityCalls of_this_thread();
};

/// Makes the calling thread as urgent as the system lets it be: the lowest real-time priority, else
/// a negative nice value, else nothing.
ThreadPriority raise_priority(const PriorityCalls& calls = PriorityCalls::of_this_thread());

/// Takes back what raise_priority() was granted in this thread.
void restore_priority(const ThreadPriority& granted);

}  // namespace eyebridge
