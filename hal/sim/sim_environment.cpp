#include "sim/sim_environment.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "eyebridge/camera/robot_eye.hpp"

namespace eyebridge::hal {
namespace {

RobotLook look_at(const robot::Simulation& sim, robot::RobotIndex robot) {
  RobotLook look;
  look.body = sim.body(robot);
  look.pose = sim.pose(robot);
  look.odometry = sim.odometry(robot);
  look.twist = sim.twist(robot);
  look.stalled = sim.stalled(robot);
  look.is_there = sim.is_there(robot);
  look.altitude = sim.altitude(robot);
  look.depth = sim.depth(robot);
  if (sim.model(robot).camera) look.eye = camera::eye_of(sim, robot);
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
    look.objects.clear();
    for (std::size_t i = 0; i < sim.world().object_count(); ++i) {
      look.objects.push_back(sim.world().object_body(i));
    }
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

template <class Act>
auto SimEnvironment::with_robot(std::size_t index, Act act) {
  using Answer = decltype(act(std::declval<robot::Simulation&>(), robot::RobotIndex{}));
  return world_.locked([&](robot::Simulation& sim) -> Answer {
    const auto robot = robot_there(sim, index);
    if (!robot) return tl::unexpected(robot.error());
    return act(sim, *robot);
  });
}

Result<void> SimEnvironment::drive(std::size_t index, const Twist& twist) {
  if (!std::isfinite(twist.linear) || !std::isfinite(twist.angular)) {
    return fail(Errc::OutOfRange, "drive: expected finite speeds");
  }
  return with_robot(index, [&](robot::Simulation& sim, robot::RobotIndex robot) -> Result<void> {
    sim.set_speed(robot, twist);
    return {};
  });
}

Result<void> SimEnvironment::set_errors(std::size_t index, const robot::RobotModel& like) {
  return with_robot(index, [&](robot::Simulation& sim, robot::RobotIndex robot) -> Result<void> {
    try {
      sim.set_errors(robot, like);
      return {};
    } catch (const std::invalid_argument& error) {
      return fail(Errc::OutOfRange, error.what());
    }
  });
}

Result<robot::RobotModel> SimEnvironment::present_model(std::size_t index) {
  return with_robot(
      index, [](robot::Simulation& sim, robot::RobotIndex robot) -> Result<robot::RobotModel> {
        return sim.model(robot);
      });
}

}  // namespace eyebridge::hal
