#pragma once

#include <cstdint>
#include <limits>

#include "eyebridge/base/result.hpp"

namespace eyebridge::hal {

/// What a person at a window does to a world's time. Robot programs notice nothing: their clocks
/// stand still or go slower with it. Any thread; no call waits for a step.
class TimeControl {
 public:
  /// The factor of a world that goes as fast as the computer can.
  static constexpr double kFastest = std::numeric_limits<double>::infinity();

  virtual ~TimeControl() = default;

  /// Time stands still after the step that is under way; whoever waits goes on waiting.
  virtual void pause() = 0;
  virtual void resume() = 0;
  [[nodiscard]] virtual bool is_paused() const = 0;
  /// One step of the simulation while time stands still; nothing while it does not.
  virtual void step() = 0;

  /// Seconds of the world in a second of real time.
  [[nodiscard]] virtual double factor() const = 0;
  /// From now on. OutOfRange unless `factor` > 0, and for kFastest where time is real.
  virtual Result<void> set_factor(double factor) = 0;

  /// How often real time slipped because the computer was too slow; 0 in virtual time.
  [[nodiscard]] virtual std::uint64_t overruns() const { return 0; }
};

}  // namespace eyebridge::hal
