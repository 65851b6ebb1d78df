#pragma once

#include <atomic>
#include <utility>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::robios {

class Session;
struct TurnMember;

/// What belongs to a flow of a program: to a thread, or to one of several that take turns in it
/// (fleet/fiber.hpp), which has its own.
struct Flow {
  Session* session = nullptr;  ///< Of its robot; null when that is the process's only one.
  /// Of the only robot's program: its place among its threads (threads/thread_turns.hpp); else
  /// null.
  TurnMember* member = nullptr;
  /// Where the member's other threads see whether it is in a call; null without one.
  std::atomic<bool>* in_call = nullptr;
  /// Calls of the API that it is in.
  int calls = 0;
  bool is_away = false;  ///< In a call that waits for what other threads may have to do first.
  /// What looks at the time have cost since the last call, which charges it.
  Time looked{0};
  bool in_timer = false;        ///< It runs the function of a timer.
  int kernel_calls = 0;         ///< Of classic RoBIOS's multitasking.
  void* kernel_task = nullptr;  ///< Likewise: which task it is.
};

// Asked at every call: where the thread's start is, and not through a function. The library may be
// loaded late (by Python); there is always room for so little.
inline thread_local constinit Flow flow [[gnu::tls_model("initial-exec")]];

/// The looks, to be charged now.
inline Time take_looks() { return std::exchange(flow.looked, Time(0)); }

/// Tells the member's other threads.
inline void show_in_call(bool is_in_call) {
  if (flow.in_call == nullptr) return;
  flow.in_call->store(is_in_call && !flow.is_away, std::memory_order_release);
}

/// Counts one call.
class InCall {
 public:
  InCall() {
    if (flow.calls++ == 0) show_in_call(true);
  }
  ~InCall() {
    if (--flow.calls == 0) show_in_call(false);
  }
  InCall(const InCall&) = delete;
  InCall& operator=(const InCall&) = delete;
};

/// In a call, where the robot's program goes on: in its timers' functions, or where its threads
/// wait for each other.
class OutOfCall {
 public:
  OutOfCall()
      : depth_(std::exchange(flow.calls, 0)), was_away_(std::exchange(flow.is_away, false)) {
    show_in_call(false);
  }
  ~OutOfCall() {
    flow.calls = depth_;
    flow.is_away = was_away_;
    show_in_call(depth_ > 0);
  }
  OutOfCall(const OutOfCall&) = delete;
  OutOfCall& operator=(const OutOfCall&) = delete;

 private:
  const int depth_;
  const bool was_away_;
};

}  // namespace eyebridge::robios
