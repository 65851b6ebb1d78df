#pragma once

#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// One motor. Using it takes the robot out of v-omega control.
///
/// The backend owns it; any thread. Fails with Timeout or Disconnected on hardware.
class Motor : public Device {
 public:
  /// Uncontrolled: `duty` -1 … 1 of full voltage, positive is forward; else OutOfRange.
  virtual Result<void> set_duty(double duty) = 0;
  /// Controlled: encoder ticks per second, positive is forward; switches PID on. What is faster
  /// than the motor can is clamped to its top speed without an error: it turns as fast as it can.
  /// OutOfRange only for what is not finite.
  virtual Result<void> set_speed(double ticks_per_second) = 0;
  /// Gains of the controller, 0 … 255 each as the IO7 board takes them; else OutOfRange.
  virtual Result<void> set_pid(int p, int i, int d) = 0;
};

/// One quadrature encoder.
///
/// The backend owns it; any thread. Fails with Timeout or Disconnected on hardware.
class Encoder : public Device {
 public:
  /// Ticks since the last reset (the start, at first); forward counts up. Wraps around as 32 bits
  /// do.
  virtual Result<int> read() = 0;
  /// Makes it 0. A drive under way does not notice.
  virtual Result<void> reset() = 0;
};

}  // namespace eyebridge::hal
