#pragma once

#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/planning/path_progress.hpp"

namespace eyebridge::planning {

struct PurePursuitSettings {
  double lookahead = 0.25;  ///< How far ahead it aims, metres, > 0. Cuts corners by less than this.
  double speed = 0.3;       ///< Never faster, m/s, > 0.
  double max_angular = 2.0;   ///< Never turns faster, rad/s, > 0.
  double deceleration = 0.5;  ///< Before the end of the path, m/s^2, > 0.
  double tolerance = 0.02;    ///< Nearer to the end it has arrived, metres, > 0.
};

/// Follows a path from its start by driving, at each call, the arc to a place of it some way ahead;
/// turns on the spot while that place is more than 60 degrees off. Speeds stay within the settings,
/// but may jump: the robot's own controller ramps them. Obstacles are the planner's business: leave
/// room for the corners that it cuts. Not thread-safe.
///
/// Coulter, "Implementation of the Pure Pursuit Path Tracking Algorithm", CMU-RI-TR-92-01 (1992).
class PurePursuit {
 public:
  /// Throws std::invalid_argument for settings out of range, or for no points (metres).
  explicit PurePursuit(std::vector<Vec2> points, const PurePursuitSettings& settings = {});

  /// What to drive from `pose`, until the next call; nothing once arrived.
  Twist follow(const Pose& pose);

  /// Whether the last follow() found the robot at the path's end.
  [[nodiscard]] bool has_arrived() const { return arrived_; }
  [[nodiscard]] const PathProgress& progress() const { return progress_; }

 private:
  PathProgress progress_;
  PurePursuitSettings settings_;
  bool arrived_ = false;
};

}  // namespace eyebridge::planning
