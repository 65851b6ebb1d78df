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

/// Tells the sanitizers of a switch between stacks; nothing without them.
class SanitizedSwitch {
 public:
  SanitizedSwitch() = default;
  SanitizedSwitch(const SanitizedSwitch&) = delete;
  SanitizedSwitch& operator=(const SanitizedSwitch&) = delete;

#if defined(__SANITIZE_ADDRESS__)
  /// Before the switch to a fiber with this stack.
  void enter(const void* bottom, std::size_t size) {
    __sanitizer_start_switch_fiber(&resumer_fake_, bottom, size);
  }
  /// Back from it.
  void returned() { __sanitizer_finish_switch_fiber(resumer_fake_, nullptr, nullptr); }
  /// On the fiber, which was resumed.
  void arrived() { __sanitizer_finish_switch_fiber(fake_, &resumer_, &resumer_size_); }
  /// On the fiber, before the switch back.
  void leave() { __sanitizer_start_switch_fiber(&fake_, resumer_, resumer_size_); }
  void leave_for_good() { __sanitizer_start_switch_fiber(nullptr, resumer_, resumer_size_); }

 private:
  void* fake_ = nullptr;
  void* resumer_fake_ = nullptr;
  const void* resumer_ = nullptr;
  std::size_t resumer_size_ = 0;
#elif defined(__SANITIZE_THREAD__)
  ~SanitizedSwitch() {
    if (fiber_ != nullptr) __tsan_destroy_fiber(fiber_);
  }
  void enter(const void* /*bottom*/, std::size_t /*size*/) {
    if (fiber_ == nullptr) fiber_ = __tsan_create_fiber(0);
    resumer_ = __tsan_get_current_fiber();
    __tsan_switch_to_fiber(fiber_, 0);
  }
  void returned() {}
  void arrived() {}
  void leave() { __tsan_switch_to_fiber(resumer_, 0); }
  void leave_for_good() { leave(); }

 private:
  void* fiber_ = nullptr;
  void* resumer_ = nullptr;
#else
  void enter(const void* /*bottom*/, std::size_t /*size*/) {}
  void returned() {}
  void arrived() {}
  void leave() {}
  void leave_for_good() {}
#endif
};

}  // namespace eyebridge::robios
