#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <set>
#include <thread>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/thread_priority.hpp"
#include "eyebridge/hal/time_control.hpp"

namespace eyebridge::hal {

/// Wall time, scaled, and the thread that steps a world along with it. Any thread.
///
/// The clock never runs ahead of the world: now() stays below the end of the step that is due. When
/// the machine cannot keep up, time slips instead of steps being heaped up, and the slip is
/// counted.
class RealTimeClock final : public Clock, public TimeControl {
 public:
  enum class Start { AtOnce, Later };

  /// `factor` > 0: seconds of this clock in a second of wall time. `step_world` is called from the
  /// clock's thread, once for each `step` of time; it must not call the clock.
  RealTimeClock(Time step, double factor, std::function<void()> step_world,
                Start start = Start::AtOnce);
  /// Ends the thread. Nobody may be waiting.
  ~RealTimeClock() override;
  RealTimeClock(const RealTimeClock&) = delete;
  RealTimeClock& operator=(const RealTimeClock&) = delete;

  [[nodiscard]] Time now() const override;
  [[nodiscard]] Time at(Time moment) const override;
  void wait_until(Time deadline) override;
  void spend(Time) override {}
  [[nodiscard]] bool is_virtual() const override { return false; }

  /// Time that starts later starts; else nothing.
  void begin();

  void pause() override;
  void resume() override;
  [[nodiscard]] bool is_paused() const override;
  void step() override;
  [[nodiscard]] double factor() const override;
  Result<void> set_factor(double factor) override;

  /// How often time slipped because the world fell too far behind.
  [[nodiscard]] std::uint64_t overruns() const override;
  /// What the system granted the thread that steps the world, which must not be late.
  [[nodiscard]] const ThreadPriority& priority() const { return priority_; }

 private:
  using Wall = std::chrono::steady_clock;

  void run();
  // The rest: mutex_ is held.
  [[nodiscard]] Time scaled(Wall::time_point moment) const;
  [[nodiscard]] Time scaled() const { return scaled(Wall::now()); }
  [[nodiscard]] Time latest() const;
  [[nodiscard]] Time shown() const;
  [[nodiscard]] Wall::time_point wall_of(Time time) const;
  void anchor(Time time);
  [[nodiscard]] bool stands() const { return paused_ || !begun_; }
  void start_or_stop(bool& flag, bool value);

  const Time step_;
  const std::function<void()> step_world_;

  mutable std::mutex mutex_;
  double factor_;
  Time longest_lag_;
  std::condition_variable changed_;  ///< For the world's thread: resumed, or ending.
  std::condition_variable stepped_;  ///< For those who wait: the first deadline may have come.
  std::multiset<Time> deadlines_;
  Wall::time_point anchor_wall_;  ///< The moment at which scaled() was anchor_time_.
  Time anchor_time_{0};
  Time world_time_{0};
  std::uint64_t overruns_ = 0;
  bool begun_;
  bool paused_ = false;
  bool ending_ = false;
  ThreadPriority priority_;
  std::thread thread_;
};

}  // namespace eyebridge::hal
