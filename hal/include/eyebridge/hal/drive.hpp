#pragma once

#include "eyebridge/base/drive_goal.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/result.hpp"

namespace eyebridge::hal {

enum class DriveProgress { Done, Driving, Failed };

/// What a drive says of itself.
struct DriveStatus {
  DriveProgress progress = DriveProgress::Done;
  double remaining = 0.0;      ///< Metres to go, >= 0; 0 for turns on the spot.
  bool stalled_left = false;   ///< An obstacle holds the left wheel …
  bool stalled_right = false;  ///< … or the right one.
};

/// The v-omega drive of a robot. A new command replaces the running one.
class Drive {
 public:
  virtual ~Drive() = default;

  /// Drives at `twist` until the next command.
  virtual Result<void> set_speed(const Twist& twist) = 0;
  /// Starts towards `goal` and returns at once.
  virtual Result<void> start(const DriveGoal& goal) = 0;
  virtual Result<DriveStatus> status() = 0;
  /// Speed as measured at the wheels.
  virtual Result<Twist> measured_twist() = 0;
  /// Pose by odometry, relative to where set_odometry() said it was (the start, at first).
  virtual Result<Pose> odometry() = 0;
  virtual Result<void> set_odometry(const Pose& pose) = 0;
};

}  // namespace eyebridge::hal
