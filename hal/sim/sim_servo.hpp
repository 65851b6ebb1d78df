#pragma once

#include "eyebridge/hal/servo.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// One servo of the camera of a simulated robot.
class SimServo final : public Servo, private SimDevice {
 public:
  /// `index`: 0 is pan, 1 is tilt.
  SimServo(SimWorld& world, robot::RobotIndex robot, unsigned index);
  Result<void> set(double position) override;

 private:
  const unsigned index_;
};

}  // namespace eyebridge::hal
