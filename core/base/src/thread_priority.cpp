#include "eyebridge/base/thread_priority.hpp"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

namespace eyebridge {
namespace {

constexpr int kNice = -10;

bool set_policy(int policy, int level) {
  sched_param parameters{};
  parameters.sched_priority = level;
  return sched_setscheduler(0, policy | SCHED_RESET_ON_FORK, &parameters) == 0;
}

// On Linux a nice value is a thread's.
bool set_nice(int level) {
  return setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), level) == 0;
}

}  // namespace

std::string ThreadPriority::str() const {
  switch (kind) {
    case Kind::RealTime:
      return "real-time priority " + std::to_string(level);
    case Kind::Nice:
      return "nice " + std::to_string(level);
    case Kind::Ordinary:
      break;
  }
  return "ordinary priority";
}

PriorityCalls PriorityCalls::of_this_thread() {
  return {[](int level) { return set_policy(SCHED_RR, level); }, set_nice};
}

ThreadPriority raise_priority(const PriorityCalls& calls) {
  const int lowest = sched_get_priority_min(SCHED_RR);
  if (calls.real_time(lowest)) return {ThreadPriority::Kind::RealTime, lowest};
  if (calls.nice(kNice)) return {ThreadPriority::Kind::Nice, kNice};
  return {};
}

void restore_priority(const ThreadPriority& granted) {
  if (granted.kind == ThreadPriority::Kind::RealTime) set_policy(SCHED_OTHER, 0);
  if (granted.kind == ThreadPriority::Kind::Nice) set_nice(0);
}

}  // namespace eyebridge
