#include "remote_robot/answer.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "calls/carry_out.hpp"
#include "calls/values.hpp"
#include "eyebridge/camera/view.hpp"
#include "eyebridge/files/readers.hpp"
#include "remote_robot/remote_view.hpp"

namespace eyebridge::hal {
namespace {

Result<Values> look(const camera::View& view, const Call& call) {
  if (call.name == "scene") return pack_scene(view.scene());
  if (call.name == "eye") return pack_eye(view.eye());
  if (call.name == "noise") return pack_noise(view.noise());
  return fail(Errc::Unsupported, fmt::format("a view has no {}", call.name));
}

Result<Values> done(const Result<void>& result) {
  return result.map([] { return Values{}; });
}

Result<Values> add_object(WorldControl& world, const std::string& text) {
  try {
    return world.add_object(files::read_object_text(text, "object")).map([](int id) {
      return Values{static_cast<double>(id)};
    });
  } catch (const ConfigError& error) {
    return fail(Errc::Corrupt, error.what());
  }
}

Result<Values> set(WorldControl& world, const Call& call) {
  const Values& v = call.request;
  if (call.name == "set_errors" && !v.empty()) {
    return done(
        world.set_errors(call.id, AsValues<std::string>::unpack(std::span(v).subspan(1)), v[0]));
  }
  if (v.size() == 3 && call.name == "set_robot_pose") {
    return done(world.set_robot_pose(call.id, {v[0], v[1], v[2]}));
  }
  if (v.size() == 1 && call.name == "set_robot_altitude") {
    return done(world.set_robot_altitude(call.id, v[0]));
  }
  if (v.size() == 3 && call.name == "set_object_pose") {
    return done(world.set_object_pose(call.id, {v[0], v[1], v[2]}));
  }
  if (call.name == "add_object") return add_object(world, AsValues<std::string>::unpack(v));
  if (call.name == "change_object")
    return done(world.change_object(call.id, AsValues<std::string>::unpack(v)));
  if (call.name == "remove_object") return done(world.remove_object(call.id));
  if (v.size() == 2 && call.name == "set_object_velocity") {
    return done(world.set_object_velocity(call.id, {v[0], v[1]}));
  }
  if (v.size() == 1 && call.name == "set_object_fixed") {
    return done(world.set_object_fixed(call.id, v[0] != 0.0));
  }
  return fail(Errc::Corrupt, fmt::format("a world has no {} of {} numbers", call.name, v.size()));
}

Result<Values> ask(WorldControl& world, const Call& call) {
  if (call.is_command) return set(world, call);
  if (call.name == "robot_count") return Values{static_cast<double>(world.robot_count())};
  if (call.name == "object_count") return Values{static_cast<double>(world.object_count())};
  if (call.name == "robot_pose") return world.robot_pose(call.id).map(packed<Pose>);
  if (call.name == "robot_altitude") {
    return world.robot_altitude(call.id).map(packed<double>);
  }
  if (call.name == "object_pose") return world.object_pose(call.id).map(packed<Pose>);
  return fail(Errc::Unsupported, fmt::format("a world has no {}", call.name));
}

}  // namespace

Result<Values> answer(Backend& robot, const Call& call) {
  if (call.device == "view" && robot.camera_view() != nullptr) {
    return look(*robot.camera_view(), call);
  }
  if (call.device == "world" && robot.world() != nullptr) return ask(*robot.world(), call);
  return carry_out(robot, call);
}

}  // namespace eyebridge::hal
