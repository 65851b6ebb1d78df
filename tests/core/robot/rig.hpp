#pragma once

#include <memory>
#include <utility>

#include "eyebridge/robot/simulation.hpp"

namespace eyebridge::robot {

/// A closed room of `width` x `height` metres with its lower left at the origin.
inline std::shared_ptr<const world::WorldModel> room(double width, double height) {
  auto model = std::make_shared<world::WorldModel>();
  model->width = width;
  model->height = height;
  const Vec2 corners[] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  for (std::size_t i = 0; i < 4; ++i) {
    world::Wall wall;
    wall.a = corners[i];
    wall.b = corners[(i + 1) % 4];
    model->walls.push_back(wall);
  }
  return model;
}

/// One robot in a room of 4 m x 4 m.
struct Rig {
  explicit Rig(const RobotModel& model = {}, const Pose& pose = {2.0, 2.0, 0.0},
               const SimulationSettings& settings = {})
      : sim(room(4.0, 4.0), settings), robot(sim.add_robot(model, pose)) {}

  void steps(int count) {
    for (int i = 0; i < count; ++i) sim.step();
  }
  /// Steps until the goal is over, at most `limit` steps; the steps it took.
  int finish(int limit = 10000) {
    int count = 0;
    for (; sim.drive_state(robot) == DriveState::Driving && count < limit; ++count) sim.step();
    return count;
  }

  Simulation sim;
  RobotIndex robot;
};

}  // namespace eyebridge::robot
