#pragma once

#include "eyebridge/base/pose.hpp"

namespace eyebridge::robot {

/// What a drive may do, in the form that one step needs.
struct DriveLimits {
  double dt = 0.01;             ///< Length of a step, seconds.
  double linear = 0.6;          ///< Top speed, metres per second.
  double angular = 5.0;         ///< Top speed, radians per second.
  double linear_step = 0.01;    ///< Change of speed in one step, metres per second.
  double angular_step = 0.1;    ///< Change of speed in one step, radians per second.
  double wheel = 1.7;           ///< Top speed of a wheel's rim, metres per second.
  double half_base = 0.045;     ///< Half the distance between the wheels, metres.
  double distance_end = 1e-10;  ///< A goal nearer than this is reached, metres.
  double angle_end = 1e-10;     ///< A goal nearer than this is reached, radians.
  double held = 1.0;  ///< For how many steps a speed may have to hold: the next may come late.
  /// What a step brought is known only when the next ones are under way: nearer to its goal than
  /// its end no speed is asked for, and one at which a step leads further is too fast to end with.
  bool blind = false;
};

/// `twist` clamped to the top speeds; where a wheel would be too fast, both parts are scaled, so
/// that the curvature stays.
Twist clamp_twist(const Twist& twist, const DriveLimits& limits);

/// One step of speed from `from` towards `to`, which is within the limits. Never changes a part by
/// more than its step, never asks more of a wheel than it can do; arrives exactly.
Twist approach(const Twist& from, const Twist& to, const DriveLimits& limits);

/// How much of what is left one step may drive, so that slowing down by the full deceleration in
/// the steps after it ends exactly at the goal: 0 … 1, and 1 for the last step.
///
/// `share` is the deceleration as a share of what is left: acceleration * dt^2 / remaining, > 0.
double stopping_share(double share);

}  // namespace eyebridge::robot
