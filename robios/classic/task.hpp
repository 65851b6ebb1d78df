#pragma once

#include <condition_variable>
#include <string>

#include "flow.hpp"
#include "kernel.hpp"

namespace eyebridge::robios::classic {

/// A task, under the kernel's lock.
struct Kernel::Task {
  Kernel* kernel = nullptr;
  tcb shown{};  ///< What the program sees of it.
  std::string name;
  void (*code)() = nullptr;
  State state = State::New;
  long long order = 0;  ///< When it became ready, fell asleep, or began to wait.
  Time ready_since{0};  ///< While it is ready.
  Time wake{0};         ///< While it sleeps.
  sem* waits_at = nullptr;
  bool suspended = false;  ///< While it waits at a semaphore: is not ready when it gets it.
  bool is_main = false;
  bool has_waited = false;  ///< main() counts as MIN_PRI until it gives way.
  std::condition_variable turn;

  /// Its state or whose turn it is has changed.
  void notify() {
    const OutOfCall program;
    turn.notify_all();
  }
  [[nodiscard]] int priority() const { return is_main && has_waited ? MIN_PRI : shown.pri; }
};

}  // namespace eyebridge::robios::classic
