#pragma once

#include "eyebridge/base/pose.hpp"
#include "eyebridge/planning/clearance.hpp"

namespace eyebridge::planning {

struct DynamicWindowSettings {
  double radius = 0.1;                ///< Of the robot, metres, >= 0.
  double max_linear = 0.5;            ///< m/s, > 0; it does not drive backwards.
  double max_angular = 2.0;           ///< rad/s, > 0.
  double linear_acceleration = 0.5;   ///< Both ways, m/s^2, > 0.
  double angular_acceleration = 4.0;  ///< Both ways, rad/s^2, > 0.
  double period = 0.1;                ///< Between two choices, s, > 0.
  double tolerance = 0.05;            ///< Nearer to the goal it brakes, metres, > 0.
  double look_ahead = 1.0;        ///< Obstacles farther along an arc count no more, metres, > 0.
  double heading_weight = 2.0;    ///< Of facing the goal, >= 0.
  double clearance_weight = 0.2;  ///< Of the way that is free along the arc, >= 0.
  double speed_weight = 0.4;      ///< Of driving fast, if towards the goal, >= 0.
  int linear_samples = 9;         ///< Speeds looked at, >= 2.
  int angular_samples = 21;       ///< Turning speeds looked at, >= 2.
};

/// What to drive for the next period.
struct DynamicChoice {
  Twist twist;
  bool is_braking = false;  ///< At the goal, or since no other speeds are safe.
};

/// Chooses speeds among those that the motors reach within a period and that let the robot stop
/// before it hits anything. A robot that drives them exactly, starting at rest where it has room,
/// never touches a blocked cell that stays where it is: braking along the last arc is always left.
/// Like every local method it may get stuck before obstacles: give it a place some way ahead on a
/// planned path as goal. No state; any thread.
///
/// Fox, Burgard and Thrun, "The Dynamic Window Approach to Collision Avoidance", IEEE Robotics and
/// Automation Magazine 4 (1997). Other than there, speed counts by how far the goal lies ahead, so
/// that the robot does not circle it, and its own period is part of the way to stop.
class DynamicWindow {
 public:
  /// Throws std::invalid_argument for settings out of range.
  explicit DynamicWindow(const DynamicWindowSettings& settings);

  /// From `pose`, while driving `now`, towards `goal` (metres). `clearance` is of the obstacles
  /// themselves, not widened.
  [[nodiscard]] DynamicChoice choose(const ClearanceRaster& clearance, const Pose& pose,
                                     const Twist& now, Vec2 goal) const;

 private:
  [[nodiscard]] double stopping_time(const Twist& twist) const;
  [[nodiscard]] double stopping_distance(const Twist& twist) const;
  [[nodiscard]] Twist braked(const Twist& now) const;
  [[nodiscard]] double score(const Pose& pose, const Twist& twist, double free, Vec2 goal) const;

  DynamicWindowSettings settings_;
};

}  // namespace eyebridge::planning
