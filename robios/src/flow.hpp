#pragma once

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
  /// Calls of the API that it is in: a crash there may have left something locked.
  int calls = 0;
  /// What looks at the time have cost since the last call, which charges it.
  Time looked{0};
  bool in_timer = false;        ///< It runs the function of a timer.
  int kernel_calls = 0;         ///< Of classic RoBIOS's multitasking.
  void* kernel_task = nullptr;  ///< Likewise: which task it is.
  void* stack_mark = nullptr;   ///< Of one of several robots': from where down its stack may be
                                ///< used again once the program is given up.
};

// Asked at every call: where the thread's start is, and not through a function. The library may be
// loaded late (by Python); there is always room for so little.
inline thread_local constinit Flow flow [[gnu::tls_model("initial-exec")]];

/// The looks, to be charged now.
inline Time take_looks() { return std::exchange(flow.looked, Time(0)); }

/// Counts one call.
class InCall {
 public:
  InCall() { ++flow.calls; }
  ~InCall() { --flow.calls; }
  InCall(const InCall&) = delete;
  InCall& operator=(const InCall&) = delete;
};

/// In a call, where the robot's program goes on: in its timers' functions, or where its threads
/// wait for each other.
class OutOfCall {
 public:
  OutOfCall() : depth_(flow.calls) { flow.calls = 0; }
  ~OutOfCall() { flow.calls = depth_; }
  OutOfCall(const OutOfCall&) = delete;
  OutOfCall& operator=(const OutOfCall&) = delete;

 private:
  const int depth_;
};

}  // namespace eyebridge::robios
