#include "eyebridge/robot/tally.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace eyebridge::robot {

void Tally::add_step(const Simulation& simulation) {
  distances_.resize(std::max(distances_.size(), simulation.robot_count()));
  const double step = simulation.settings().step;
  const auto count = static_cast<RobotIndex>(simulation.robot_count());
  for (RobotIndex robot = 0; robot < count; ++robot) {
    const HolonomicTwist twist = simulation.body_twist(robot);
    const double speed =
        twist.lateral == 0.0 ? std::abs(twist.linear) : norm({twist.linear, twist.lateral});
    distances_[robot] += speed * step;
  }
}

void Tally::add_collision(const CollisionEvent& event) {
  for (const std::optional<RobotIndex>& robot : {event.robot, event.with_robot}) {
    if (!robot) continue;
    collisions_.resize(std::max(collisions_.size(), std::size_t{*robot} + 1));
    ++collisions_[*robot];
  }
}

double Tally::distance(RobotIndex robot) const {
  return robot < distances_.size() ? distances_[robot] : 0.0;
}

std::uint64_t Tally::collisions(RobotIndex robot) const {
  return robot < collisions_.size() ? collisions_[robot] : 0;
}

double Tally::distance() const {
  return std::accumulate(distances_.begin(), distances_.end(), 0.0);
}

std::uint64_t Tally::collisions() const {
  return std::accumulate(collisions_.begin(), collisions_.end(), std::uint64_t{0});
}

}  // namespace eyebridge::robot
