#pragma once

#include <cstdint>
#include <vector>

#include "eyebridge/robot/simulation.hpp"

namespace eyebridge::robot {

/// What the robots of a simulation have done so far: how far each drove, how often it hit
/// something, how long it stood in vain. Looks only: counting changes no run. Not thread-safe.
class Tally {
 public:
  /// After every step of `simulation`: adds the way that each robot drove in it, forwards or back.
  /// Robots that a person moved by hand have not driven.
  void add_step(const Simulation& simulation);
  /// For each event that the simulation reports (Simulation::on_collision).
  void add_collision(const CollisionEvent& event);

  /// Metres along the way, >= 0; 0 for a robot that is not there.
  [[nodiscard]] double distance(RobotIndex robot) const;
  /// New contacts; 0 for a robot that is not there.
  [[nodiscard]] std::uint64_t collisions(RobotIndex robot) const;
  /// Sums over all robots.
  [[nodiscard]] double distance() const;
  [[nodiscard]] std::uint64_t collisions() const;
  /// The longest time, seconds, for which one of them stood although it was told to move.
  [[nodiscard]] double longest_stuck() const;

 private:
  std::vector<double> distances_;
  std::vector<std::uint32_t> stuck_;  ///< Steps, up to now without a break.
  std::uint32_t longest_stuck_ = 0;
  double step_ = 0.0;  ///< Seconds.
  std::vector<std::uint64_t> collisions_;
};

}  // namespace eyebridge::robot
