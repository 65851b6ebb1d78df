#pragma once

#include "eyebridge/hal/servo.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// One servo of a simulated robot: RobotModel::servo_indices().
class SimServo final : public Servo, private SimDevice {
 public:
  /// `index`: the number that programs use, less 1.
  SimServo(SimWorld& world, robot::RobotIndex robot, unsigned index);
  Result<void> set(double position) override;

 private:
  const unsigned index_;
};

}  // namespace eyebridge::hal
