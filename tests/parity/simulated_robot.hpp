#pragma once

#include <string>
#include <vector>

#include "eyebridge/base/pose.hpp"

namespace eyebridge::testing {

/// What a robot program does and where: one column of the comparison.
struct Task {
  std::string name;
  std::vector<std::string> program;  ///< With its arguments.
  std::string world;                 ///< File below worlds/.
  std::string robot = "S4";
};

/// The tasks of the measure: ten short motions and, unless EYEBRIDGE_TEST_PARITY is "short", a
/// square, a wall follower and a maze explorer.
std::vector<Task> tasks();

/// Where the robot really is at the end, and how far it went.
struct Course {
  Pose end;             ///< m, radians.
  double length = 0.0;  ///< m
};

/// The task in the simulation, in simulated time.
Course simulated(const Task& task);

/// What `eyebridge firmware` must be told for the task's world and robot.
std::vector<std::string> firmware_arguments(const Task& task);

}  // namespace eyebridge::testing
