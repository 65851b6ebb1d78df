#include "sim/sim_environment.hpp"

#include <algorithm>

namespace eyebridge::hal {
namespace {

RobotLook look_at(const robot::Simulation& sim, robot::RobotIndex robot) {
  RobotLook look;
  look.body = sim.body(robot);
  look.pose = sim.pose(robot);
  look.odometry = sim.odometry(robot);
  look.twist = sim.twist(robot);
  look.stalled = sim.stalled(robot);
  if (const auto& camera = sim.model(robot).camera) {
    look.pan = camera->pan + (2 * sim.servo(robot, 0) - 1) * camera->max_pan;
  }
  return look;
}

/// What `look` has not been told of yet; what the simulation has forgotten meanwhile is lost.
void tell_collisions(const robot::Simulation& sim, WorldLook& look) {
  const auto kept = sim.collisions();
  const std::uint64_t missing = sim.collision_count() - look.collision_count;
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(missing, kept.size()));
  look.collisions.assign(kept.end() - static_cast<std::ptrdiff_t>(count), kept.end());
  look.collision_count = sim.collision_count();
}

}  // namespace

void SimEnvironment::look(WorldLook& look) {
  const std::lock_guard lock(mutex_);
  world_.locked([&](const robot::Simulation& sim) {
    look.scene = sim.world().scene(sim.time());
    look.robots.clear();
    for (std::size_t i = 0; i < sim.robot_count(); ++i) {
      const auto robot = static_cast<robot::RobotIndex>(i);
      if (i == models_.size()) {
        models_.push_back(std::make_shared<const robot::RobotModel>(sim.model(robot)));
      }
      look.robots.push_back(look_at(sim, robot));
      look.robots.back().model = models_[i];
    }
    tell_collisions(sim, look);
  });
}

}  // namespace eyebridge::hal
