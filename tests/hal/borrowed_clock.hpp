#pragma once

#include "eyebridge/base/clock.hpp"

namespace eyebridge::hal::testing {

/// The clock of a bench, handed to whoever wants to own one.
class BorrowedClock final : public Clock {
 public:
  explicit BorrowedClock(Clock& clock) : clock_(clock) {}
  [[nodiscard]] Time now() const override { return clock_.now(); }
  [[nodiscard]] Time at(Time moment) const override { return clock_.at(moment); }
  void wait_until(Time deadline) override { clock_.wait_until(deadline); }
  void spend(Time cost) override { clock_.spend(cost); }
  [[nodiscard]] bool is_virtual() const override { return clock_.is_virtual(); }

 private:
  Clock& clock_;
};

}  // namespace eyebridge::hal::testing
