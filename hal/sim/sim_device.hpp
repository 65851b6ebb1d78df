#pragma once

#include <cmath>

#include "eyebridge/base/result.hpp"
#include "sim/sim_world.hpp"

namespace eyebridge::hal {

/// What every simulated device knows: its world, and the robot that it sits on.
class SimDevice {
 public:
  SimDevice(SimWorld& world, robot::RobotIndex robot) : world_(world), robot_(robot) {}

 protected:
  /// Success when `good`; else what `device` was asked for, as an error.
  static Result<void> require(bool good, const char* device, double value, const char* expected);

  SimWorld& world_;
  const robot::RobotIndex robot_;
};

}  // namespace eyebridge::hal
