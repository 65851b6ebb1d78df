#pragma once

#include <functional>
#include <mutex>

#include "eyebridge/hal/drive.hpp"

namespace eyebridge::hal {

/// Where a robot is in a simulated world whose wheels turn elsewhere: it started at a known pose,
/// and another drive's odometry says how it has moved since. Any thread.
class PoseTracker {
 public:
  /// From now on follows `drive`, which is lent and stands where `start` is in the world. To be
  /// called once, before anything else but is_used(). Fails as Drive::odometry().
  Result<void> begin(Drive& drive, const Pose& start);
  /// Whether begin() was called.
  [[nodiscard]] bool is_used() const { return drive_ != nullptr; }

  /// The robot's pose in the world. Fails as Drive::odometry().
  Result<Pose> pose();
  /// Carries out `set`, which makes the drive's odometry `odometry`: the robot has not moved.
  Result<void> rebase(const Pose& odometry, const std::function<Result<void>()>& set);

 private:
  Result<Pose> pose_now();  // under mutex_

  std::mutex mutex_;
  Drive* drive_ = nullptr;
  Pose world_;     ///< Pose in the world …
  Pose odometry_;  ///< … when the odometry was this.
};

}  // namespace eyebridge::hal
