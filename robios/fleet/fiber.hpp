#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace eyebridge::robios {

/// A flow of control with a stack of its own, in the thread that resumes it: what a robot program
/// runs as in virtual time.
///
/// The stack is mapped as it is used, with a guard below. What libraries keep for each thread
/// and robot programs notice (errno, exceptions being handled, whose robot it is) is kept for each
/// fiber. One thread for the life of the object.
class Fiber {
 public:
  /// Programs put big images on the stack: as much as a process's main thread has.
  static constexpr std::size_t kStackSize = 8U << 20U;
  /// Below it nothing can be touched. More than a page: a function with big variables would step
  /// over one, into the next robot's stack.
  static constexpr std::size_t kGuardSize = 1U << 20U;

  /// `body` runs at the first resume() and must return or suspend() for ever. Throws
  /// std::bad_alloc when there is no address space for the stack.
  explicit Fiber(std::function<void()> body, std::size_t stack_size = kStackSize);
  /// A body that has not returned never goes on; what is on its stack is not destroyed.
  ~Fiber();
  Fiber(const Fiber&) = delete;
  Fiber& operator=(const Fiber&) = delete;

  /// Runs the body until it suspends or returns. Not from inside a fiber.
  void resume();
  /// Returns from the resume() of the fiber that runs now. Only in a body.
  static void suspend();
  /// As suspend(), of a fiber that runs and was given up by its owner: it is deleted once it has
  /// been left.
  [[noreturn]] void leave_for_good();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace eyebridge::robios
