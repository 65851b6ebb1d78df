#include "sim/sim_world_control.hpp"

#include <cmath>
#include <stdexcept>

#include "eyebridge/files/error_rules.hpp"
#include "eyebridge/files/readers.hpp"

namespace eyebridge::hal {
namespace {

Error unknown(const char* kind, int id, int count) {
  return {Errc::OutOfRange, std::string("no ") + kind + ' ' + std::to_string(id) +
                                ", the world has " + std::to_string(count)};
}

/// What `act(simulation, body)` makes of object `id`, in one go: nobody can take it away meanwhile.
template <class Act>
auto with_object(SimWorld& world, int id, Act act) {
  return world.locked([&](auto& sim) -> decltype(act(sim, world::BodyId{})) {
    const auto count = static_cast<int>(sim.world().object_count());
    if (id < 1 || id > count) return tl::unexpected(unknown("object", id, count));
    const world::BodyId body = sim.world().object_body(static_cast<std::size_t>(id - 1));
    if (sim.world().is_there(body)) return act(sim, body);
    return fail(Errc::OutOfRange, "object " + std::to_string(id) + " has been removed");
  });
}

bool is_finite(const Pose& pose) { return std::isfinite(pose.x + pose.y + pose.theta); }

}  // namespace

int SimWorldControl::robot_count() const {
  return world_.locked([](auto& sim) { return static_cast<int>(sim.robot_count()); });
}

int SimWorldControl::object_count() const {
  return world_.locked([](auto& sim) { return static_cast<int>(sim.world().object_count()); });
}

Result<robot::RobotIndex> SimWorldControl::robot_index(int id) const {
  if (id == 0) return robot_;
  const int count = robot_count();
  if (id < 0 || id > count) return tl::unexpected(unknown("robot", id, count));
  return world_.locked(
      [id](auto& sim) { return robot_there(sim, static_cast<std::size_t>(id - 1)); });
}

Result<Pose> SimWorldControl::robot_pose(int id) const {
  return robot_index(id).map([&](robot::RobotIndex index) {
    return world_.locked([&](auto& sim) { return sim.pose(index); });
  });
}

Result<void> SimWorldControl::set_robot_pose(int id, const Pose& pose) {
  if (!is_finite(pose)) return fail(Errc::OutOfRange, "set robot: expected a finite pose");
  return robot_index(id).map([&](robot::RobotIndex index) {
    world_.locked([&](auto& sim) { sim.set_pose(index, pose); });
  });
}

Result<double> SimWorldControl::robot_altitude(int id) const {
  return robot_index(id).map([&](robot::RobotIndex index) {
    return world_.locked([&](auto& sim) { return sim.altitude(index); });
  });
}

Result<void> SimWorldControl::set_robot_altitude(int id, double altitude) {
  if (!std::isfinite(altitude)) {
    return fail(Errc::OutOfRange, "set robot: expected a finite altitude");
  }
  return robot_index(id).map(
      [&](robot::RobotIndex index) { world_.set_altitude(index, altitude); });
}

Result<Pose> SimWorldControl::object_pose(int id) const {
  return with_object(world_, id, [](auto& sim, world::BodyId body) -> Result<Pose> {
    return sim.world().pose(body);
  });
}

Result<void> SimWorldControl::set_object_pose(int id, const Pose& pose) {
  if (!is_finite(pose)) return fail(Errc::OutOfRange, "set object: expected a finite pose");
  return with_object(world_, id, [&](auto& sim, world::BodyId body) -> Result<void> {
    sim.world().set_pose(body, pose);
    return {};
  });
}

Result<int> SimWorldControl::add_object(const world::ObjectSpec& object) {
  return world_.locked([&](auto& sim) -> Result<int> {
    try {
      sim.world().add_object(object);
      return static_cast<int>(sim.world().object_count());
    } catch (const std::invalid_argument& error) {
      return fail(Errc::OutOfRange, error.what());
    }
  });
}

Result<void> SimWorldControl::change_object(int id, const std::string& lines) {
  return with_object(world_, id, [&](auto& sim, world::BodyId body) -> Result<void> {
    try {
      world::World& world = sim.world();
      world.change_object(body, files::read_object_change(world.object(body), lines, "object"));
      return {};
    } catch (const ConfigError& error) {
      return fail(Errc::OutOfRange, error.what());
    } catch (const std::invalid_argument& error) {
      return fail(Errc::OutOfRange, error.what());
    }
  });
}

Result<void> SimWorldControl::remove_object(int id) {
  return with_object(world_, id, [](auto& sim, world::BodyId body) -> Result<void> {
    sim.world().remove(body);
    return {};
  });
}

Result<void> SimWorldControl::set_object_velocity(int id, Vec2 velocity) {
  if (!std::isfinite(velocity.x + velocity.y)) {
    return fail(Errc::OutOfRange, "set object: expected a finite velocity");
  }
  return with_object(world_, id, [&](auto& sim, world::BodyId body) -> Result<void> {
    if (!sim.world().slides(body)) {
      return fail(Errc::OutOfRange, "object " + std::to_string(id) +
                                        " does not roll or slide: expected a ball, or one with a "
                                        "friction, that is not fixed");
    }
    sim.world().set_velocity(body, velocity);
    return {};
  });
}

Result<void> SimWorldControl::set_object_fixed(int id, bool fixed) {
  return with_object(world_, id, [&](auto& sim, world::BodyId body) -> Result<void> {
    if (sim.world().moves_by_itself(body)) {
      return fail(Errc::OutOfRange, "object " + std::to_string(id) + " moves by itself");
    }
    sim.world().set_fixed(body, fixed);
    return {};
  });
}

Result<void> SimWorldControl::set_errors(int id, const std::string& rules, double share) {
  if (!(share >= 0.0 && share <= 1.0)) {
    return fail(Errc::OutOfRange, "set errors: expected a share of them, 0 to 1");
  }
  const auto index = robot_index(id);
  if (!index) return tl::unexpected(index.error());
  try {
    return world_.locked([&](auto& sim) -> Result<void> {
      sim.set_errors(*index, files::with_errors(sim.model(*index), rules, share));
      return {};
    });
  } catch (const ConfigError& error) {
    return fail(Errc::OutOfRange, error.what());
  }
}

}  // namespace eyebridge::hal
