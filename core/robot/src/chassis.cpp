#include "chassis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "eyebridge/base/math.hpp"

namespace eyebridge::robot {

double DriveModel::max_curvature() const {
  if (kind != DriveKind::Ackermann) return std::numeric_limits<double>::infinity();
  const SinCos lock = sin_cos(max_steering);
  return lock.sin / lock.cos / axle_distance;
}

Chassis::Chassis(const DriveModel& model, const MotorModel& motor)
    : wheels_(std::max(model.encoder_count(), model.motor_count())),
      motor_count_(model.motor_count()),
      encoder_count_(model.encoder_count()) {
  for (ChassisWheel& wheel : wheels_) wheel.motor = motor;
}

Rims Chassis::run() {
  Rims motors{};
  for (std::size_t i = 0; i < motor_count_; ++i) motors[i] = obey(i);
  return rims_of(motors);
}

double Chassis::obey(std::size_t index) {
  ChassisWheel& w = wheels_[index];
  return w.command.controlled ? w.wheel.drive_controlled(w.command.speed, w.motor)
                              : w.wheel.drive(w.command.speed, w.motor);
}

Rims Chassis::blocked(const Rims& travel, double progress) const {
  Rims rims = travel;
  for (std::size_t i = 0; i < rims.size(); ++i) {
    if (is_held(i)) rims[i] *= progress;
  }
  return rims;
}

void Chassis::settle(const Rims& /*travel*/, const Ground& /*ground*/, bool /*held*/) {}

void Chassis::start(const DriveGoal& goal, const Twist& present, DriveController& controller) {
  controller.start(goal, present);
}

void Chassis::set_twist(const HolonomicTwist& twist, const Twist& present,
                        DriveController& controller) {
  controller.set_speed({twist.linear, twist.angular}, present);
}

void Chassis::add_to(StateHash& hash) const {
  for (const ChassisWheel& w : wheels_) {
    hash.add(w.wheel.speed());
    hash.add(w.wheel.travel());
  }
}

Twist Chassis::present() const {
  Rims speeds{};
  for (std::size_t i = 0; i < motor_count_; ++i) speeds[i] = wheels_[i].wheel.speed();
  const BodyStep step = seen(rims_of(speeds));
  return {step.forward, step.angle};
}

PathStep Chassis::rolling() const {
  Rims motors{};
  for (std::size_t i = 0; i < motor_count_; ++i) {
    motors[i] = wheels_[i].wheel.rolling(wheels_[i].motor);
  }
  const BodyStep step = seen(rims_of(motors));
  return {step.forward, step.angle};
}

bool Chassis::is_commanded() const {
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    if (wheels_[i].command.speed != 0.0 && !is_apart(i)) return true;
  }
  return false;
}

bool Chassis::stands(double speed) const {
  return std::all_of(wheels_.begin(), wheels_.end(),
                     [&](const ChassisWheel& w) { return std::abs(w.wheel.speed()) <= speed; });
}

void Chassis::halt() {
  for (ChassisWheel& w : wheels_) w.wheel.halt();
}

void Chassis::drop_commands() {
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    if (!is_apart(i)) wheels_[i].command = {};
  }
}

ChassisWheel& Chassis::motor(unsigned index) {
  if (index >= motor_count_) throw std::out_of_range("no such motor");
  return wheels_[index];
}

ChassisWheel& Chassis::encoder(unsigned index) {
  if (index >= encoder_count_) throw std::out_of_range("no such encoder");
  return wheels_[index];
}

std::unique_ptr<Chassis> make_chassis(const RobotModel& robot, const MotorModel& motor,
                                      double water) {
  const DriveModel& model = robot.drive;
  switch (model.kind) {
    case DriveKind::Differential:
      break;
    case DriveKind::Ackermann:
      return make_ackermann(model, motor);
    case DriveKind::Omni:
    case DriveKind::Swedish:
      return make_omni(model, motor);
    case DriveKind::Synchro:
      return make_synchro(model, motor);
    case DriveKind::Submarine:
      return make_submarine(robot, motor, water);
  }
  return nullptr;
}

}  // namespace eyebridge::robot
