#pragma once

#include <string>

#include "calls/values.hpp"
#include "eyebridge/files/readers.hpp"
#include "eyebridge/hal/world_control.hpp"
#include "remote_robot/robot_line.hpp"

namespace eyebridge::hal {

/// The hand of God through a robot's line to its server, which is lent.
class RemoteWorld final : public WorldControl {
 public:
  explicit RemoteWorld(RobotLine& line) : line_(line) {}

  [[nodiscard]] int robot_count() const override { return count("robot_count"); }
  [[nodiscard]] int object_count() const override { return count("object_count"); }
  Result<Pose> robot_pose(int id) const override { return pose(id, "robot_pose"); }
  Result<void> set_robot_pose(int id, const Pose& pose) override {
    return command(id, "set_robot_pose", packed(pose));
  }
  Result<double> robot_altitude(int id) const override {
    const Call call{"world", id, "robot_altitude", false, {}};
    return reply_as<double>(call, line_.ask(call));
  }
  Result<void> set_robot_altitude(int id, double altitude) override {
    return command(id, "set_robot_altitude", {altitude});
  }
  Result<Pose> object_pose(int id) const override { return pose(id, "object_pose"); }
  Result<void> set_object_pose(int id, const Pose& pose) override {
    return command(id, "set_object_pose", packed(pose));
  }
  /// As text: numbers of objects that a `.sim` file cannot say are OutOfRange, too.
  Result<int> add_object(const world::ObjectSpec& object) override {
    try {
      const Call call{"world", 0, "add_object", true, packed(files::write_object_text(object))};
      return reply_as<int>(call, line_.ask(call));
    } catch (const ConfigError& error) {
      return fail(Errc::OutOfRange, error.what());
    }
  }
  Result<void> remove_object(int id) override { return command(id, "remove_object", {}); }
  Result<void> set_object_velocity(int id, Vec2 velocity) override {
    return command(id, "set_object_velocity", {velocity.x, velocity.y});
  }
  Result<void> set_object_fixed(int id, bool fixed) override {
    return command(id, "set_object_fixed", {fixed ? 1.0 : 0.0});
  }
  Result<void> change_object(int id, const std::string& lines) override {
    return command(id, "change_object", packed(lines));
  }
  Result<void> set_errors(int id, const std::string& rules, double share) override {
    return command(id, "set_errors", packed(share, rules));
  }

 private:
  /// 0 once the server is gone.
  [[nodiscard]] int count(std::string_view name) const {
    const Call call{"world", 0, name, false, {}};
    return reply_as<int>(call, line_.ask(call)).value_or(0);
  }
  [[nodiscard]] Result<Pose> pose(int id, std::string_view name) const {
    const Call call{"world", id, name, false, {}};
    return reply_as<Pose>(call, line_.ask(call));
  }
  Result<void> command(int id, std::string_view name, Values request) {
    return line_.ask({"world", id, name, true, std::move(request)}).map([](const Values&) {});
  }

  RobotLine& line_;
};

}  // namespace eyebridge::hal
