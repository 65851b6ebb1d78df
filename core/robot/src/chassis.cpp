#include "chassis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "eyebridge/base/math.hpp"

namespace eyebridge::robot {

unsigned DriveModel::motor_count() const {
  switch (kind) {
    case DriveKind::Ackermann:
      return 1;
    case DriveKind::Omni:
      return 4;
    case DriveKind::Swedish:
      return 3;
    case DriveKind::Differential:
    case DriveKind::Synchro:
      break;
  }
  return 2;
}

unsigned DriveModel::encoder_count() const {
  return kind == DriveKind::Ackermann ? 2 : motor_count();
}

double DriveModel::max_curvature() const {
  if (kind != DriveKind::Ackermann) return std::numeric_limits<double>::infinity();
  const SinCos lock = sin_cos(max_steering);
  return lock.sin / lock.cos / axle_distance;
}

Chassis::Chassis(const DriveModel& model, const MotorModel& motor)
    : wheels_(model.encoder_count()), motor_count_(model.motor_count()) {
  for (ChassisWheel& wheel : wheels_) wheel.motor = motor;
}

Rims Chassis::run() {
  Rims motors{};
  for (std::size_t i = 0; i < motor_count_; ++i) {
    ChassisWheel& w = wheels_[i];
    motors[i] = w.command.controlled ? w.wheel.drive_controlled(w.command.speed, w.motor)
                                     : w.wheel.drive(w.command.speed, w.motor);
  }
  return rims_of(motors);
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
  return std::any_of(wheels_.begin(), wheels_.end(),
                     [](const ChassisWheel& w) { return w.command.speed != 0.0; });
}

bool Chassis::stands(double speed) const {
  return std::all_of(wheels_.begin(), wheels_.end(),
                     [&](const ChassisWheel& w) { return std::abs(w.wheel.speed()) <= speed; });
}

void Chassis::halt() {
  for (ChassisWheel& w : wheels_) w.wheel.halt();
}

void Chassis::drop_commands() {
  for (ChassisWheel& w : wheels_) w.command = {};
}

ChassisWheel& Chassis::motor(unsigned index) {
  if (index >= motor_count_) throw std::out_of_range("no such motor");
  return wheels_[index];
}

std::unique_ptr<Chassis> make_chassis(const DriveModel& model, const MotorModel& motor) {
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
  }
  return nullptr;
}

}  // namespace eyebridge::robot
