#pragma once

#include <cstddef>

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/asan_interface.h>
#include <sanitizer/common_interface_defs.h>
#endif
#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace eyebridge::robios {

/// A stack is about to be unmapped, perhaps in the middle of its functions: what lies there next
/// has nothing to do with their variables.
inline void forget_stack([[maybe_unused]] const void* bottom, [[maybe_unused]] std::size_t size) {
#if defined(__SANITIZE_ADDRESS__)
  __asan_unpoison_memory_region(bottom, size);
#endif
}

/// What the sanitizers are told when one flow is left for another; nothing without them. Each flow
/// has one: a fiber, and the thread that they run in.
class SanitizedSwitch {
 public:
  /// Of the calling thread's own flow.
  SanitizedSwitch() = default;
  SanitizedSwitch(const SanitizedSwitch&) = delete;
  SanitizedSwitch& operator=(const SanitizedSwitch&) = delete;

#if defined(__SANITIZE_ADDRESS__)
  /// It is a fiber's, with this stack.
  void know(const void* bottom, std::size_t size) {
    bottom_ = bottom;
    size_ = size;
  }
  /// Before this flow is left for another.
  void leave(const SanitizedSwitch& to) {
    __sanitizer_start_switch_fiber(&fake_, to.bottom_, to.size_);
  }
  void leave_for_good(const SanitizedSwitch& to) {
    __sanitizer_start_switch_fiber(nullptr, to.bottom_, to.size_);
  }
  /// When this flow goes on, or begins. Notes which stack the other one has.
  void arrive(SanitizedSwitch& from) {
    __sanitizer_finish_switch_fiber(fake_, &from.bottom_, &from.size_);
  }

 private:
  void* fake_ = nullptr;
  const void* bottom_ = nullptr;
  std::size_t size_ = 0;
#elif defined(__SANITIZE_THREAD__)
  ~SanitizedSwitch() {
    if (own_ != nullptr) __tsan_destroy_fiber(own_);
  }
  void know(const void* /*bottom*/, std::size_t /*size*/) { own_ = __tsan_create_fiber(0); }
  void leave(const SanitizedSwitch& to) {
    __tsan_switch_to_fiber(to.own_ != nullptr ? to.own_ : to.thread_, 0);
  }
  void leave_for_good(const SanitizedSwitch& to) { leave(to); }
  void arrive(SanitizedSwitch& /*from*/) {}

 private:
  void* own_ = nullptr;
  void* thread_ = __tsan_get_current_fiber();
#else
  void know(const void* /*bottom*/, std::size_t /*size*/) {}
  void leave(const SanitizedSwitch& /*to*/) {}
  void leave_for_good(const SanitizedSwitch& /*to*/) {}
  void arrive(SanitizedSwitch& /*from*/) {}
#endif
};

}  // namespace eyebridge::robios
