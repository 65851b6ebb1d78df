#include "environment/orbit.hpp"

#include <algorithm>
#include <cmath>

namespace eyebridge::gui {
namespace {

constexpr double kLowest = deg_to_rad(2);
constexpr double kHighest = deg_to_rad(89);

}  // namespace

Orbit Orbit::of_floor(Vec2 near, Vec2 far) {
  const Vec2 extent = far - near;
  Orbit orbit;
  orbit.target = near + Vec2{0.5 * extent.x, 0.45 * extent.y};
  // As far as it is wide, so that it fits an opening of 60 degrees with some room.
  orbit.distance = std::clamp(1.15 * std::max(extent.x, extent.y), kNearest, kFarthest);
  orbit.height = deg_to_rad(50);
  return orbit;
}

Orbit Orbit::behind(const Pose& robot) {
  constexpr double kAhead = 0.25;  // metres: what comes is more than what was
  Orbit orbit;
  orbit.target = robot.position() + kAhead * Heading::from_angle(robot.theta).forward();
  orbit.heading = robot.theta;
  orbit.distance = 0.9;
  orbit.height = deg_to_rad(28);
  return orbit;
}

camera::Eye Orbit::eye() const {
  const double along = distance * std::cos(height);
  camera::Eye eye;
  eye.x = target.x - along * std::cos(heading);
  eye.y = target.y - along * std::sin(heading);
  eye.z = distance * std::sin(height);
  eye.heading = heading;
  eye.pitch = -height;
  return eye;
}

void Orbit::turn(double around, double up) {
  heading = wrap_angle(heading + around);
  height = std::clamp(height + up, kLowest, kHighest);
}

void Orbit::move_away(double factor) {
  distance = std::clamp(distance * factor, kNearest, kFarthest);
}

void Orbit::shift(double right, double ahead) {
  const Vec2 forward = Heading::from_angle(heading).forward();
  target = target + ahead * forward + right * Vec2{forward.y, -forward.x};
}

}  // namespace eyebridge::gui
