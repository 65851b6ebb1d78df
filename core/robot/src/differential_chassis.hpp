#pragma once

#include "chassis.hpp"

namespace eyebridge::robot {

/// A left and a right wheel, each with its motor. In a header for step.cpp, which is compiled for
/// it beside all others.
class DifferentialChassis final : public Chassis {
 public:
  DifferentialChassis(const DriveModel& model, const MotorModel& motor) : Chassis(model, motor) {
    wheels_[0].side = 1.0;
    wheels_[1].side = -1.0;
  }

  /// As Chassis has it, but of a number that the compiler knows.
  std::span<ChassisWheel, 2> wheels() { return std::span<ChassisWheel, 2>(storage_.data(), 2); }

  Rims follow(const DriveController& controller, const Twist& twist) override {
    const double turning = twist.angular * controller.limits().half_base;
    return {drive(0, twist.linear - turning), drive(1, twist.linear + turning)};
  }

  [[nodiscard]] BodyStep seen(const Rims& travel) const override {
    const PathStep path = path_of({travel[0], travel[1]}, wheel_base_);
    return {path.distance, 0.0, path.angle};
  }

  [[nodiscard]] BodyStep ground(const Rims& travel, const Ground& ground) const override {
    const BodyStep step = seen(travel);
    return {step.forward * ground.way, 0.0, step.angle * ground.turn};
  }

  [[nodiscard]] PathStep rolling() const override {
    const auto rolls = [](const ChassisWheel& w) { return w.wheel.rolling(w.motor); };
    return path_of({rolls(storage_[0]), rolls(storage_[1])}, wheel_base_);
  }

  /// The wheels go on with what turns the robot.
  [[nodiscard]] Rims blocked(const Rims& travel, double progress) const override {
    const double lost = (1.0 - progress) * (travel[0] + travel[1]) / 2;
    return {travel[0] - lost, travel[1] - lost};
  }

  /// Rounded as it always was: runs are the same to the bit.
  [[nodiscard]] HolonomicTwist speed(const BodyStep& step, double progress,
                                     double dt) const override {
    return {step.forward * progress / dt, 0.0, step.angle / dt};
  }

  [[nodiscard]] bool repeats() const override { return true; }

  void add_to(StateHash& hash) const override { add_wheels_to(hash); }
};

}  // namespace eyebridge::robot
