#pragma once

#include "eyebridge/hal/motor.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// One motor of a simulated robot.
class SimMotor final : public Motor, private SimDevice {
 public:
  /// `index`: which one it is, as robot::DriveKind says.
  SimMotor(SimWorld& world, robot::RobotIndex robot, unsigned index);

  Result<void> set_duty(double duty) override;
  Result<void> set_speed(double ticks_per_second) override;
  Result<void> set_pid(int p, int i, int d) override;

 private:
  const unsigned index_;
};

/// Its encoder. Counts wrap at 32 bits.
class SimEncoder final : public Encoder, private SimDevice {
 public:
  /// `index`: which one it is, as robot::DriveKind says.
  SimEncoder(SimWorld& world, robot::RobotIndex robot, unsigned index);

  Result<int> read() override;
  Result<void> reset() override;

 private:
  const unsigned index_;
};

}  // namespace eyebridge::hal
