#pragma once

#include "eyebridge/robot/simulation.hpp"
#include "robot_state.hpp"

namespace eyebridge::robot {

/// Whether `servo`, turned from `before` to `after`, lets the kicker strike.
bool strikes(const KickerModel& kicker, unsigned servo, double before, double after);

struct Simulation::Impl {
  Impl(std::shared_ptr<const world::WorldModel> model, const SimulationSettings& given);

  // Both throw std::out_of_range.
  [[nodiscard]] RobotState& at(RobotIndex robot) { return states.at(robot); }
  [[nodiscard]] RobotDevices& devices_of(RobotIndex robot) { return devices.at(robot); }
  /// How far a device on `robot` sees, metres; `reach` when nothing is nearer.
  [[nodiscard]] double look(RobotIndex robot, const Sight& device, double reach) const;
  /// One step of one robot: from command to pose.
  void step_robot(RobotIndex robot);
  /// Keeps account of stalls after a move that an obstacle `held`, or not.
  void account(RobotState& state, bool held);
  /// Kicks the ball that is nearest to the kicker, if one is in its reach.
  void strike(RobotIndex robot, const KickerModel& kicker);
  /// Tells of the contacts that began in the step that has just ended.
  void report_collisions();
  [[nodiscard]] std::optional<RobotIndex> robot_of(world::BodyId body) const;

  SimulationSettings settings;
  world::World world;
  std::uint64_t steps = 0;
  std::uint32_t stall_timeout_steps;
  std::vector<RobotState> states;
  std::vector<RobotDevices> devices;
  std::function<void(const CollisionEvent&)> listener;
  std::vector<CollisionEvent> collisions;
  std::uint64_t collisions_dropped = 0;
  std::vector<Vec2> contacts;  // of the reading at hand; kept for its memory
};

}  // namespace eyebridge::robot
