#pragma once

#include "eyebridge/hal/servo.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// One servo of a simulated robot: of its camera or of its kicker.
class SimServo final : public Servo, private SimDevice {
 public:
  /// `index`: 0 is pan, 1 is tilt, others as the robot's model says.
  SimServo(SimWorld& world, robot::RobotIndex robot, unsigned index);
  Result<void> set(double position) override;

 private:
  const unsigned index_;
};

}  // namespace eyebridge::hal
