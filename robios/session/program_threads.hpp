#pragma once

#include <mutex>
#include <utility>

#include "eyebridge/base/clock.hpp"
#include "flow.hpp"
#include "thread_turns.hpp"

namespace eyebridge::robios {

/// The threads of the program of the process's only robot. Never destroyed.
ThreadTurns& program_threads();

/// The calling thread makes a call of the program: it is one of its threads from now on, if it was
/// not known yet (an interpreter's) and is none of ours.
void join_program_threads();

/// The calling thread runs no program, or no longer.
void leave_program_threads();

/// The session will be in virtual time: the program's time is the robot's from its start, so that
/// runs repeat (`srand(time(NULL))`), and its first sleep begins the session as a call would. (A
/// look does not: what counts memory may look at any time.)
void expect_virtual_time();

/// Within a call: what it waits for may never come, or only when other threads of the program have
/// done something, which go on while it sleeps. In virtual time the caller has its turn again at
/// the end. Any thread.
class Away {
 public:
  Away() : was_away_(std::exchange(flow.is_away, true)) { show_in_call(flow.calls > 0); }
  ~Away() {
    flow.is_away = was_away_;
    show_in_call(flow.calls > 0);
    if (!was_away_ && flow.member != nullptr) program_threads().come_back(*flow.member);
  }
  Away(const Away&) = delete;
  Away& operator=(const Away&) = delete;

 private:
  const bool was_away_;
};

template <class Body>
auto while_away(Body body) {
  const Away away;
  return body();
}

/// Locks what somebody may keep while he waits for his turn.
inline std::unique_lock<std::mutex> lock_in_turn(std::mutex& mutex) {
  std::unique_lock lock(mutex, std::try_to_lock);
  if (lock) return lock;
  const Away away;
  lock.lock();
  return lock;
}

/// A virtual clock that a program's threads share by turns. Others go on at once. Any thread.
class TurnClock final : public Clock {
 public:
  /// Both are lent.
  TurnClock(Clock& clock, ThreadTurns& turns) : clock_(clock), turns_(turns) {}

  [[nodiscard]] Time now() const override { return clock_.now(); }
  void wait_until(Time deadline) override {
    if (flow.member == nullptr) return clock_.wait_until(deadline);
    turns_.wait(*flow.member, deadline);
  }
  void spend(Time cost) override {
    if (flow.member == nullptr || turns_.is_alone()) return clock_.spend(cost);
    turns_.wait(*flow.member, now() + cost);
  }
  [[nodiscard]] bool is_virtual() const override { return true; }

 private:
  Clock& clock_;
  ThreadTurns& turns_;
};

}  // namespace eyebridge::robios
