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

/// One of several of its kind.
class SimNumbered : protected SimDevice {
 public:
  /// `index` into the list of the robot's model, or as robot::DriveKind counts its motors.
  SimNumbered(SimWorld& world, robot::RobotIndex robot, std::size_t index)
      : SimDevice(world, robot), index_(static_cast<unsigned>(index)) {}

 protected:
  const unsigned index_;
};

}  // namespace eyebridge::hal
