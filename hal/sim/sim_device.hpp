#pragma once

#include "sim/sim_world.hpp"

namespace eyebridge::hal {

/// What every simulated device knows: its world, and the robot that it sits on.
class SimDevice {
 public:
  SimDevice(SimWorld& world, robot::RobotIndex robot) : world_(world), robot_(robot) {}

 protected:
  SimWorld& world_;
  const robot::RobotIndex robot_;
};

}  // namespace eyebridge::hal
