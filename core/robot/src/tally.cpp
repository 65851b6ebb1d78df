#include "eyebridge/robot/tally.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace eyebridge::robot {

void Tally::add_step(const Simulation& simulation) {
  distances_.resize(std::max(distances_.size(), simulation.robot_count()));
  stuck_.resize(distances_.size());
  const double step = step_ = simulation.settings().step;
  const auto count = static_cast<RobotIndex>(simulation.robot_count());
  for (RobotIndex robot = 0; robot < count; ++robot) {
    const HolonomicTwist twist = simulation.body_twist(robot);
    const double speed =
        twist.lateral == 0.0 ? std::abs(twist.linear) : norm({twist.linear, twist.lateral});
    distances_[robot] += speed * step;
    if (speed != 0.0 || twist.angular != 0.0 || !simulation.is_told_to_move(robot)) {
      stuck_[robot] = 0;
    } else {
      longest_stuck_ = std::max(longest_stuck_, ++stuck_[robot]);
    }
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

double Tally::longest_stuck() const { return longest_stuck_ * step_; }

std::uint64_t Tally::collisions() const {
  return std::accumulate(collisions_.begin(), collisions_.end(), std::uint64_t{0});
}

}  // namespace eyebridge::robot
