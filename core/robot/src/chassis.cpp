#include "chassis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "eyebridge/base/math.hpp"

namespace eyebridge::robot {

void check_model(bool good, const char* what) {
  if (!good) throw std::invalid_argument(what);
}

double DriveModel::max_curvature() const {
  if (!facts().steers_front()) return std::numeric_limits<double>::infinity();
  const SinCos lock = sin_cos(max_steering);
  return lock.sin / lock.cos / axle_distance;
}

Chassis::Chassis(const DriveModel& model, const MotorModel& motor)
    : motor_count_(model.motor_count()),
      encoder_count_(model.encoder_count()),
      wheel_base_(model.wheel_base) {
  wheels_ = std::span(storage_).first(std::max(motor_count_, encoder_count_));
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

BodyStep Chassis::ground(const Rims& travel, const Ground& ground) const {
  const BodyStep step = seen(travel);
  return {step.forward * ground.way, step.left * ground.way, step.angle * ground.turn};
}

Rims Chassis::blocked(const Rims& travel, double progress) const {
  Rims rims = travel;
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    if (wheels_[i].rolls) rims[i] *= progress;
  }
  return rims;
}

HolonomicTwist Chassis::speed(const BodyStep& step, double progress, double dt) const {
  const double share = progress / dt;
  return {step.forward * share, step.left * share,
          step.angle * (can_turn_on_spot() ? 1.0 / dt : share)};
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
  // Two wheels that no such robot has: hashes of older runs have them.
  for (int i = 0; i < 4; ++i) hash.add(0.0);
  add_wheels_to(hash);
}

void Chassis::add_wheels_to(StateHash& hash) const {
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
                     [](const ChassisWheel& w) { return w.command.speed != 0.0 && !w.is_apart; });
}

void Chassis::halt() {
  for (ChassisWheel& w : wheels_) w.wheel.halt();
}

void Chassis::drop_commands() {
  for (ChassisWheel& w : wheels_) {
    if (!w.is_apart) w.command = {};
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

}  // namespace eyebridge::robot
