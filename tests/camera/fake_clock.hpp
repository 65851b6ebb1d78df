#pragma once

#include <algorithm>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::camera::testing {

/// Virtual time that moves only when somebody waits; waking up may be made late.
class FakeClock final : public Clock {
 public:
  [[nodiscard]] Time now() const override { return now_; }
  void wait_until(Time deadline) override {
    if (deadline > now_) now_ = deadline + lateness;
  }
  void spend(Time cost) override { now_ += cost; }
  [[nodiscard]] bool is_virtual() const override { return true; }

  Time lateness{0};  ///< Added to every wait.

 private:
  Time now_{0};
};

}  // namespace eyebridge::camera::testing
