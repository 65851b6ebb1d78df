#pragma once

#include <functional>
#include <mutex>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/result.hpp"

namespace eyebridge::hal {

/// Where a robot is in a simulated world whose wheels turn elsewhere: it started at a known pose,
/// and another backend says how it has moved since. Any thread.
class PoseTracker {
 public:
  /// Says where the robot is in the frame of another backend.
  using Source = std::function<Result<Pose>()>;

  /// From now on follows `source`, whose robot stands where `start` is in the world. To be called
  /// once, before anything else but follows_odometry(). Fails as `source`.
  Result<void> begin(Source source, bool is_odometry, const Pose& start);
  /// From now on the robot is where `source` says, in the world. Asks nothing yet; to be called
  /// once, in the place of begin().
  void follow(Source source);
  /// Whether what is followed is a drive's odometry, which programs may set.
  [[nodiscard]] bool follows_odometry() const { return is_odometry_; }

  /// The robot's pose in the world. Fails as the source.
  Result<Pose> pose();
  /// Carries out `set`, which makes the odometry `odometry`: the robot has not moved.
  Result<void> rebase(const Pose& odometry, const std::function<Result<void>()>& set);

 private:
  Result<Pose> pose_now();  // under mutex_

  std::mutex mutex_;
  Source source_;
  bool is_odometry_ = false;
  Pose world_;  ///< Pose in the world …
  Pose there_;  ///< … when the source said this. Both are the origin of a source in the world.
};

}  // namespace eyebridge::hal
