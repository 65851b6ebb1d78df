#pragma once

#include <chrono>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::bridges {

/// The computer's steady clock, 0 when made: the time that real links live in.
class MonotonicClock final : public Clock {
 public:
  [[nodiscard]] Time now() const override { return std::chrono::steady_clock::now() - start_; }
  [[nodiscard]] Time at(Time moment) const override { return moment - start_.time_since_epoch(); }
  void wait_until(Time deadline) override;
  void spend(Time) override {}
  [[nodiscard]] bool is_virtual() const override { return false; }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace eyebridge::bridges
