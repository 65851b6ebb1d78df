#pragma once

#include <cstddef>
#include <functional>

#include <boost/context/detail/fcontext.hpp>

#include "sanitized_switch.hpp"

// What the C++ runtime keeps of a thread's exceptions: Itanium C++ ABI, section 2.2.2.
namespace __cxxabiv1 {
struct __cxa_eh_globals;
}

namespace eyebridge::robios {

/// A flow of control that others are left for, and that goes on where it left off.
struct Lane {
  boost::context::detail::fcontext_t context = nullptr;  ///< Where it goes on.
  Lane* to = nullptr;                                    ///< Whom it was left for.
  SanitizedSwitch switching;
};

/// A lane with a stack of its own, in the thread that resumes it: what a robot program runs as in
/// virtual time.
///
/// The stack is mapped as it is used, with a guard below. What libraries keep for each thread
/// and robot programs notice (errno, exceptions being handled, whose robot it is) is kept for each
/// fiber. One thread for the life of the object.
class Fiber : private Lane {
 public:
  /// Programs put big images on the stack: as much as a process's main thread has.
  static constexpr std::size_t kStackSize = 8U << 20U;
  /// Below it nothing can be touched. More than a page: a function with big variables would step
  /// over one, into the next robot's stack.
  static constexpr std::size_t kGuardSize = 1U << 20U;

  /// `body` runs when the fiber is gone on with first, and must not return but leave for good.
  /// Throws std::bad_alloc when there is no address space for the stack.
  explicit Fiber(std::function<void()> body, std::size_t stack_size = kStackSize);
  /// A body that has not left never goes on; what is on its stack is not destroyed.
  ~Fiber();
  Fiber(const Fiber&) = delete;
  Fiber& operator=(const Fiber&) = delete;

  /// Goes on with it, until it or one that it hands over to suspends or leaves. Not from inside a
  /// fiber: no robot is here() while the caller goes on.
  void resume();
  /// Lets the processor read what it needs to go on, which is soon.
  void fetch() const {
    constexpr std::ptrdiff_t kLine = 64;
    constexpr int kLines = 12;  // the registers, and the frames of one call of ours
    for (int i = 0; i < kLines; ++i)
      __builtin_prefetch(static_cast<const char*>(context) + i * kLine, 1);
  }
  /// Goes on in the resume() that began it all. By the body of the running fiber, as the next two.
  void suspend();
  /// Goes on with `next`, which has suspended or handed over, or never ran.
  void hand_over(Fiber& next);
  /// As suspend(), for the last time.
  [[noreturn]] void leave_for_good();

 private:
  /// Memory that takes none until it is touched, above a guard that nothing may touch.
  class Stack {
   public:
    explicit Stack(std::size_t size);
    ~Stack();
    Stack(const Stack&) = delete;
    Stack& operator=(const Stack&) = delete;

    [[nodiscard]] char* bottom() const { return static_cast<char*>(base_) + kGuardSize; }
    [[nodiscard]] char* top() const { return static_cast<char*>(base_) + size_; }
    [[nodiscard]] std::size_t usable() const { return size_ - kGuardSize; }

   private:
    std::size_t size_;
    void* base_;
  };

  static void enter(boost::context::detail::transfer_t from);
  void begin_anew() const;
  void leave(Lane& next);

  // First what every switch needs, after the Lane.
  Lane* home_ = nullptr;  ///< Of the thread, in resume().
  int* const error_;      ///< errno, which is the thread's, as are its exceptions.
  __cxxabiv1::__cxa_eh_globals* const exceptions_;
  Stack stack_;
  std::function<void()> body_;
};

}  // namespace eyebridge::robios
