#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/hal/time_control.hpp"

namespace eyebridge::hal {

/// What a person does to virtual time: whoever is about to make a step passes here first. Open and
/// unhurried at first, and then next to free.
class TimeGate final : public TimeControl {
 public:
  /// `step`: of the simulation.
  explicit TimeGate(Time step) : step_(step) {}

  /// Returns when the next step may be made.
  void pass() {
    if (!is_open_.load(std::memory_order_acquire)) wait();
  }

  void pause() override;
  void resume() override;
  [[nodiscard]] bool is_paused() const override;
  void step() override;
  [[nodiscard]] double factor() const override;
  Result<void> set_factor(double factor) override;

 private:
  using Wall = std::chrono::steady_clock;

  void wait();
  void change();  ///< mutex_ is held.

  const Time step_;
  std::atomic<bool> is_open_ = true;  ///< Neither paused nor hurried.
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool is_paused_ = false;
  int single_steps_ = 0;  ///< That may be made while paused.
  double factor_ = kFastest;
  Wall::time_point next_{};  ///< When the next step may be made, with a factor.
};

}  // namespace eyebridge::hal
