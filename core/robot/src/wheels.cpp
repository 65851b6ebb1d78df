#include <algorithm>
#include <stdexcept>

#include "simulation_impl.hpp"

// What drives single wheels and the steering, and what they tell.

namespace eyebridge::robot {
namespace {

/// A motor is commanded, which takes the robot out of v-omega control, unless it is apart from
/// that.
void command_motor(RobotState& state, ChassisWheel& wheel, double speed, bool controlled) {
  if (!wheel.is_apart) state.use_motors();
  wheel.command = {std::clamp(speed, -wheel.motor.top, wheel.motor.top), controlled};
}

}  // namespace

void Simulation::set_motor_duty(RobotIndex robot, unsigned motor, double duty) {
  RobotState& state = impl_->command(robot);
  ChassisWheel& wheel = state.chassis->motor(motor);
  command_motor(state, wheel, std::clamp(duty, -1.0, 1.0) * wheel.motor.top, false);
}

void Simulation::set_motor_speed(RobotIndex robot, unsigned motor, double ticks_per_second) {
  RobotState& state = impl_->command(robot);
  ChassisWheel& wheel = state.chassis->motor(motor);
  if (model(robot).drive.encoder_count() == 0) {
    throw std::out_of_range("robot: no encoder to control a motor's speed by");
  }
  command_motor(state, wheel, ticks_per_second / wheel.motor.ticks_per_metre, true);
}

void Simulation::set_wheel(RobotIndex robot, unsigned motor, double radians_per_second) {
  const double ticks = model(robot).drive.ticks_per_revolution;
  set_motor_speed(robot, motor, radians_per_second * ticks / (2 * kPi));
}

void Simulation::set_motor_pid(RobotIndex robot, unsigned motor, int p, int i, int d) {
  impl_->command(robot).chassis->motor(motor).wheel.set_gains(
      {std::clamp(p, 0, 255), std::clamp(i, 0, 255), std::clamp(d, 0, 255)});
}

std::int64_t Simulation::encoder_ticks(RobotIndex robot, unsigned motor) const {
  const ChassisWheel& w = impl_->at(robot).chassis->encoder(motor);
  return w.wheel.ticks(w.motor);
}

void Simulation::reset_encoder(RobotIndex robot, unsigned motor) {
  ChassisWheel& w = impl_->command(robot).chassis->encoder(motor);
  w.wheel.reset_ticks(w.motor);
}

void Simulation::set_twist(RobotIndex robot, const HolonomicTwist& twist) {
  RobotState& state = impl_->command(robot);
  const Twist present = state.present();
  state.clear_stall();
  if (state.by_motors) state.chassis->release();
  state.by_motors = false;
  state.chassis->set_twist(twist, present, state.controller);
}

HolonomicTwist Simulation::body_twist(RobotIndex robot) const { return impl_->at(robot).driven; }

void Simulation::set_steering(RobotIndex robot, double angle) {
  RobotState& state = impl_->command(robot);
  if (!model(robot).drive.facts().steers_front()) {
    throw std::out_of_range("robot: no front wheels to steer");
  }
  state.use_motors();
  state.chassis->set_steering(angle);
}

double Simulation::altitude(RobotIndex robot) const { return impl_->at(robot).chassis->altitude(); }

std::optional<double> Simulation::depth(RobotIndex robot) const {
  if (!model(robot).drive.facts().dives) return std::nullopt;
  const Chassis& chassis = *impl_->at(robot).chassis;
  return chassis.highest() - chassis.altitude();
}

double Simulation::set_altitude(RobotIndex robot, double altitude) {
  RobotState& state = impl_->command(robot);
  if (!state.has_left) state.chassis->set_altitude(altitude);
  return state.chassis->altitude();
}

double Simulation::steering(RobotIndex robot) const { return impl_->at(robot).chassis->steering(); }

}  // namespace eyebridge::robot
