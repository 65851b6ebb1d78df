#pragma once

#include <algorithm>
#include <atomic>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/hal/turns.hpp"

namespace eyebridge::hal {

/// Virtual time of one of several robots: it advances by itself within a round, and beyond when all
/// others are there, too. One thread of the robot at a time; now() any.
class RoundClock final : public Clock {
 public:
  /// `turns` is lent; the robot comes at `start`.
  RoundClock(Turns& turns, std::size_t robot, Time start)
      : turns_(turns), robot_(robot), limit_(turns.limit_of(robot)), now_(start.count()) {}

  [[nodiscard]] Time now() const override { return Time(now_.load(std::memory_order_relaxed)); }
  void wait_until(Time deadline) override { advance_to(deadline); }
  void spend(Time cost) override { advance_to(now() + std::max(cost, Time(0))); }
  [[nodiscard]] bool is_virtual() const override { return true; }

 private:
  void advance_to(Time time) {
    if (time <= now()) return;
    if (time >= limit_) turns_.wait(robot_, time);
    // Another thread of the robot may have gone further meanwhile.
    now_.store(std::max(now(), time).count(), std::memory_order_relaxed);
  }

  Turns& turns_;
  const std::size_t robot_;
  const Time& limit_;
  std::atomic<Time::rep> now_;
};

}  // namespace eyebridge::hal
