#pragma once

#include <pthread.h>

#include "flow.hpp"
#include "guarded.hpp"
#include "kernel.hpp"

namespace eyebridge::robios::classic {

/// The multitasking of the calling thread's robot. Any thread.
Kernel& kernel();

/// guarded() for the calls of classic RoBIOS: tasks take turns before it, and a task that was ended
/// ends its thread here, where nothing of ours is on its stack any more.
template <class Value, class Body>
Value call(const Call& name, Value failure, Body&& body) {
  try {
    const InCall in_call;  // the kernel has locks, too
    Kernel& tasks = kernel();
    tasks.enter();
    const Value value = guarded(name, failure, body);
    tasks.leave();
    return value;
  } catch (const TaskEnded&) {
  }
  pthread_exit(nullptr);
}

/// As call(), for what only succeeds or fails: 0 or `failure`.
template <class Body>
int doing(const Call& name, int failure, Body&& body) {
  return call(name, failure, [&](Session& session) -> Result<int> {
    const Result<void> done = body(session);
    if (!done) return tl::unexpected(done.error());
    return 0;
  });
}

/// Waits on the robot's clock; other tasks may run meanwhile.
inline void wait_until(Time deadline) { kernel().wait_until(deadline); }

/// 1/100 s: what RoBIOS counts time in.
inline constexpr Time kTick = std::chrono::milliseconds(10);

}  // namespace eyebridge::robios::classic
