#pragma once

#include "eyebridge/hal/motor.hpp"
#include "eyebridge/hal/servo.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// One motor of a simulated robot.
class SimMotor final : public Motor, private SimNumbered {
 public:
  using SimNumbered::SimNumbered;
  Result<void> set_duty(double duty) override;
  Result<void> set_speed(double ticks_per_second) override;
  Result<void> set_pid(int p, int i, int d) override;
};

/// Its encoder. Counts wrap at 32 bits.
class SimEncoder final : public Encoder, private SimNumbered {
 public:
  using SimNumbered::SimNumbered;
  Result<int> read() override;
  Result<void> reset() override;
};

/// One servo of a simulated robot: RobotModel::servo_indices().
class SimServo final : public Servo, private SimNumbered {
 public:
  using SimNumbered::SimNumbered;
  Result<void> set(double position) override;
};

}  // namespace eyebridge::hal
