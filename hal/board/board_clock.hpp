#pragma once

#include "eyebridge/base/clock.hpp"

namespace eyebridge::hal {

/// The time that a board's program lives in: that of its line, from 0 when the board was ready.
class BoardClock final : public Clock {
 public:
  /// `line`, the clock of the board's line, must outlive this.
  explicit BoardClock(Clock& line) : line_(line), start_(line.now()) {}
  [[nodiscard]] Time now() const override { return line_.now() - start_; }
  [[nodiscard]] Time at(Time moment) const override { return line_.at(moment) - start_; }
  void wait_until(Time deadline) override { line_.wait_until(after_start(deadline)); }
  void spend(Time cost) override { line_.spend(cost); }
  [[nodiscard]] bool is_virtual() const override { return line_.is_virtual(); }

 private:
  /// A deadline of Time::max() is one that never comes.
  [[nodiscard]] Time after_start(Time deadline) const {
    return deadline > Time::max() - start_ ? Time::max() : deadline + start_;
  }

  Clock& line_;
  const Time start_;
};

}  // namespace eyebridge::hal
