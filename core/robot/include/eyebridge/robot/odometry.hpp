#pragma once

#include "eyebridge/base/pose.hpp"
#include "eyebridge/robot/arc.hpp"

namespace eyebridge::robot {

/// Where the robot believes to be: the sum of the arcs its wheels report.
class Odometry {
 public:
  /// Puts the estimate somewhere.
  void set(const Pose& pose) {
    position_ = pose.position();
    heading_ = Heading::from_angle(pose.theta);
  }

  /// Adds one step.
  void add(const world::Arc& arc) {
    position_ = position_ + heading_.rotate(arc.displacement);
    heading_ = heading_.turned(arc.turn);
    // One Newton step of 1 / sqrt keeps the vector a unit vector over millions of steps.
    const double scale = 1.5 - 0.5 * (heading_.cos * heading_.cos + heading_.sin * heading_.sin);
    heading_ = {heading_.cos * scale, heading_.sin * scale};
  }

  [[nodiscard]] Vec2 position() const { return position_; }
  [[nodiscard]] Heading heading() const { return heading_; }
  /// theta in (-pi, pi].
  [[nodiscard]] Pose pose() const { return {position_.x, position_.y, heading_.angle()}; }

 private:
  Vec2 position_;
  Heading heading_;
};

}  // namespace eyebridge::robot
