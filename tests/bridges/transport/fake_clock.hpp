#pragma once

#include <algorithm>
#include <mutex>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::bridges::testing {

/// Virtual time that moves only when somebody waits.
class FakeClock final : public Clock {
 public:
  [[nodiscard]] Time now() const override {
    const std::lock_guard lock(mutex_);
    return now_;
  }
  void wait_until(Time deadline) override {
    const std::lock_guard lock(mutex_);
    now_ = std::max(now_, deadline);
  }
  void spend(Time cost) override {
    const std::lock_guard lock(mutex_);
    now_ += cost;
  }
  [[nodiscard]] bool is_virtual() const override { return true; }

 private:
  mutable std::mutex mutex_;
  Time now_{0};
};

}  // namespace eyebridge::bridges::testing
