#pragma once

#include <atomic>

namespace eyebridge::hal {

/// A lock for what takes less time than a function call: std::mutex costs two, and some more where
/// programs' threads take turns and the launcher stands in for the C library. For std::lock_guard.
class WorldLock {
 public:
  void lock() {
    if (!try_lock()) wait();
  }
  bool try_lock() {
    unsigned before = kFree;
    return state_.compare_exchange_strong(before, kTaken, std::memory_order_acquire,
                                          std::memory_order_relaxed);
  }
  void unlock() {
    if (state_.exchange(kFree, std::memory_order_release) == kAwaited) state_.notify_one();
  }

 private:
  static constexpr unsigned kFree = 0;
  static constexpr unsigned kTaken = 1;
  static constexpr unsigned kAwaited = 2;  ///< Taken, and somebody may be waiting for it.

  void wait() {
    while (state_.exchange(kAwaited, std::memory_order_acquire) != kFree) state_.wait(kAwaited);
  }

  std::atomic<unsigned> state_ = kFree;
};

}  // namespace eyebridge::hal
