#pragma once

#include "eyebridge/base/result.hpp"

namespace eyebridge::hal {

/// One motor. Using it takes the robot out of v-omega control.
class Motor {
 public:
  virtual ~Motor() = default;

  /// Uncontrolled: `duty` -1 … 1.
  virtual Result<void> set_duty(double duty) = 0;
  /// Controlled: encoder ticks per second; switches PID on.
  virtual Result<void> set_speed(double ticks_per_second) = 0;
  /// Gains of the controller, 0 … 255 each as the IO7 board takes them.
  virtual Result<void> set_pid(int p, int i, int d) = 0;
};

/// One quadrature encoder.
class Encoder {
 public:
  virtual ~Encoder() = default;

  /// Ticks since the last reset; forward counts up.
  virtual Result<int> read() = 0;
  virtual Result<void> reset() = 0;
};

}  // namespace eyebridge::hal
