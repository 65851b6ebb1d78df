#pragma once

#include <atomic>
#include <functional>
#include <mutex>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::hal {

/// Virtual time for one robot: whoever waits steps the world itself, in its own thread, so that
/// nothing is handed over and nothing sleeps. Any thread.
class LockstepClock final : public Clock {
 public:
  /// `step_world` is called once for each `step` of time that passes. It must not call the clock,
  /// but for now(). What it throws goes to whoever waits; that step counts as made.
  LockstepClock(Time step, std::function<void()> step_world);

  [[nodiscard]] Time now() const override { return Time(now_.load(std::memory_order_acquire)); }
  void wait_until(Time deadline) override;
  void spend(Time cost) override;
  [[nodiscard]] bool is_virtual() const override { return true; }

 private:
  void advance_to(Time time);

  const Time step_;
  const std::function<void()> step_world_;
  std::mutex mutex_;  ///< Held while time moves.
  Time world_time_{0};
  std::atomic<Time::rep> now_{0};
};

}  // namespace eyebridge::hal
