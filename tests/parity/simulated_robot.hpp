#pragma once

#include <string>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "running_program.hpp"

namespace eyebridge::testing {

/// What a robot program does and where: one column of the comparison.
struct Task {
  std::string name;
  std::vector<std::string> program;  ///< With its arguments.
  std::string world;                 ///< File below worlds/.
  std::string robot = "S4";
};

/// The tasks of the measure: square, wall follower, maze explorer, ten short motions.
std::vector<Task> tasks();

/// Where the robot really is at the end, and how far it went.
struct Course {
  Pose end;             ///< m, radians.
  double length = 0.0;  ///< m
};

/// The task in the simulation, in simulated time.
Course simulated(const Task& task);

/// `eyebridge firmware` in a process of its own, with one board that drives the task's robot.
class FirmwareProcess {
 public:
  /// Returns when the board listens. Throws std::runtime_error with what was said instead.
  FirmwareProcess(const Task& task, const std::vector<std::string>& options);

  /// What `--hal` must be to reach the board, by its own word.
  [[nodiscard]] const std::string& hal() const { return hal_; }
  /// Ends the process as Ctrl-C does; where the robot really is then. Throws std::runtime_error.
  Pose stop();

 private:
  RunningProgram program_;
  std::string hal_;
};

/// The robot's own HDT file, as a lecturer would keep it beside the robot; its path in `folder`.
std::string hdt_file(const Task& task, const ScratchFolder& folder);

}  // namespace eyebridge::testing
