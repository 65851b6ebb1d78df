#pragma once

#include "eyebridge/robot/simulation.hpp"
#include "robot_state.hpp"

namespace eyebridge::robot {

struct Simulation::Impl {
  Impl(std::shared_ptr<const world::WorldModel> model, const SimulationSettings& given);

  // All three throw std::out_of_range.
  [[nodiscard]] RobotState& at(RobotIndex robot) { return states.at(robot); }
  /// at(), for a command: what the robot did so far need not go on.
  [[nodiscard]] RobotState& command(RobotIndex robot) {
    RobotState& state = at(robot);
    state.steady = false;
    return state;
  }
  [[nodiscard]] RobotDevices& devices_of(RobotIndex robot) { return devices.at(robot); }
  /// How far a device on `robot` sees, metres; `reach` when nothing is nearer.
  [[nodiscard]] double look(RobotIndex robot, const Sight& device, double reach) const;
  /// One step of one robot: from command to pose.
  void step_robot(RobotIndex robot);
  /// Keeps account of stalls and contacts after a move.
  void account(RobotIndex robot, RobotState& state, const world::MoveResult& result);

  SimulationSettings settings;
  world::World world;
  std::uint64_t steps = 0;
  std::uint32_t stall_timeout_steps;
  std::vector<RobotState> states;
  std::vector<RobotDevices> devices;
  std::function<void(const CollisionEvent&)> listener;
  std::vector<Vec2> contacts;  // of the reading at hand; kept for its memory
};

}  // namespace eyebridge::robot
