#pragma once

#include "eyebridge/world/world.hpp"

namespace eyebridge::robot {

/// How far each wheel (or the robot's centre and heading) went in one step.
struct WheelTravel {
  double left = 0.0;   ///< Along the ground, metres.
  double right = 0.0;  ///< Along the ground, metres.
};

/// Path of the robot's centre over one step: a circular arc.
struct PathStep {
  double distance = 0.0;  ///< Along the arc, metres; negative is backwards.
  double angle = 0.0;     ///< Change of heading, radians; positive is counter-clockwise.

  friend constexpr bool operator==(const PathStep&, const PathStep&) = default;
};

/// Motion of a robot's centre over one step at a constant speed in its own frame, sideways, too.
struct BodyStep {
  double forward = 0.0;  ///< Speed times duration, metres.
  double left = 0.0;     ///< Likewise.
  double angle = 0.0;    ///< Change of heading, radians; positive is counter-clockwise.

  friend constexpr bool operator==(const BodyStep&, const BodyStep&) = default;
};

/// What a differential drive does when its wheels travel so far; `wheel_base` in metres.
constexpr PathStep path_of(const WheelTravel& wheels, double wheel_base) {
  return {(wheels.left + wheels.right) / 2, (wheels.right - wheels.left) / wheel_base};
}

/// The exact chord and turn of a circular arc. Same bits on every machine.
world::Arc arc_of(const PathStep& path);

/// screw_of() where there is a sideways part.
world::Arc sideways_screw_of(const BodyStep& step);
/// The same of a motion that also goes sideways: the exponential of a constant twist in the plane
/// (Lynch and Park, Modern Robotics, 2017, section 3.3.3.2). Without `left`, arc_of()'s bits.
inline world::Arc screw_of(const BodyStep& step) {
  return step.left == 0.0 ? arc_of(PathStep{step.forward, step.angle}) : sideways_screw_of(step);
}

}  // namespace eyebridge::robot
