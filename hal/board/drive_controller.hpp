#pragma once

#include "eyebridge/base/clock.hpp"
#include "eyebridge/hal/drive.hpp"

namespace eyebridge::hal {

/// What drives a board's wheels by v-omega: the board itself, or the host.
///
/// As hal::Drive, but arguments are finite, speeds not negative. Any thread.
class DriveController {
 public:
  virtual ~DriveController() = default;

  virtual Result<void> set_speed(const Twist& twist) = 0;
  virtual Result<void> start(const DriveGoal& goal) = 0;
  virtual Result<DriveStatus> status() = 0;
  virtual Result<Twist> measured_twist() = 0;
  virtual Result<Pose> odometry() = 0;
  virtual Result<void> set_odometry(const Pose& pose) = 0;

  /// The motors are in other hands from now on: the running command is over, nothing is sent.
  virtual void release() = 0;
  /// The board was lost and is back, standing: the running command has failed. The board's thread.
  virtual void restarted() = 0;
  /// 10 ms have passed. The board's thread.
  virtual void step() {}
};

}  // namespace eyebridge::hal
