#pragma once

#include "eyebridge/base/drive_goal.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// Where the last command of a drive stands.
enum class DriveProgress {
  Done,     ///< Nothing under way that could end: no goal, or it is reached; or set_speed() rules.
  Driving,  ///< A goal is under way.
  Failed,   ///< The last goal was given up; stays until the next command.
};

/// What a drive says of itself.
struct DriveStatus {
  DriveProgress progress = DriveProgress::Done;
  double remaining = 0.0;      ///< Metres to go, >= 0; 0 for turns on the spot.
  bool stalled_left = false;   ///< An obstacle holds the left wheel …
  bool stalled_right = false;  ///< … or the right one.
};

/// The v-omega drive of a robot. A new command replaces the running one.
///
/// The backend owns it; any thread. Metres, radians, seconds; counter-clockwise is positive. Every
/// call fails with Timeout or Disconnected on hardware and blocks no longer than the link's
/// timeout; numbers that are not finite are OutOfRange, and the running command goes on.
class Drive : public Device {
 public:
  /// Drives at `twist`, metres and radians per second, until the next command. What is faster than
  /// the robot can is clamped without an error.
  virtual Result<void> set_speed(const Twist& twist) = 0;
  /// Starts towards `goal` and returns at once. A speed beyond the robot's is clamped without an
  /// error, a negative one is OutOfRange; a goal without length or speed is done at once and stops
  /// the robot.
  virtual Result<void> start(const DriveGoal& goal) = 0;
  /// Of the last command.
  virtual Result<DriveStatus> status() = 0;
  /// Speed as measured at the wheels, metres and radians per second.
  virtual Result<Twist> measured_twist() = 0;
  /// Pose by odometry, metres and radians, relative to where set_odometry() said it was (the start,
  /// at first); the heading is in (-pi, pi].
  virtual Result<Pose> odometry() = 0;
  /// Says that the robot stands at `pose` (metres, any heading) now. The running command goes on.
  virtual Result<void> set_odometry(const Pose& pose) = 0;
};

}  // namespace eyebridge::hal
