#pragma once

#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/world/world_model.hpp"
#include "optics/eye_pose.hpp"

namespace eyebridge::camera::testing {

/// Somebody who carries a camera through a maze, from its first start to the cell farthest from it
/// and back: smooth, swaying a little as people do. Known exactly at any time.
class MazeWalk {
 public:
  /// `speed` in metres per second.
  MazeWalk(const world::WorldModel& maze, double speed);

  [[nodiscard]] EyePose at(double seconds) const;
  [[nodiscard]] double duration() const;

 private:
  [[nodiscard]] Vec2 on_path(double metres) const;

  std::vector<Vec2> path_;  ///< Every kStep metres.
  double speed_;
};

}  // namespace eyebridge::camera::testing
