#pragma once

#include <cstdint>

#include "eb_board.h"
#include "eyebridge/robot/simulation.hpp"

namespace eyebridge::pins {

/// What a board must know of the robot that it drives, out of the robot's model.
eb_drive_config drive_config(const robot::DriveModel& model, std::uint32_t stall_timeout_us);

// The wires between one robot of a simulation and the board that drives it. Both functions throw
// std::out_of_range when there is no such robot.

/// What the robot's wheels and sensors do arrives at the inner side of `pins`.
void read_pins(robot::Simulation& simulation, robot::RobotIndex robot, eb_pins& pins);

/// What the outer side of `pins` says drives the robot's motors and servos.
void obey_pins(const eb_pins& pins, robot::Simulation& simulation, robot::RobotIndex robot);

}  // namespace eyebridge::pins
