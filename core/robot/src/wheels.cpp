#include <algorithm>
#include <stdexcept>

#include "simulation_impl.hpp"

// What drives single wheels and the steering, and what they tell.

namespace eyebridge::robot {
namespace {

/// A wheel with its motor, whatever kind of drive it belongs to.
struct MotorRef {
  Wheel& wheel;
  const MotorModel& model;
  MotorCommand& command;
};

/// A motor is commanded: it takes the robot out of v-omega control, unless it is apart from that.
void take_over(RobotState& state, unsigned motor) {
  if (state.chassis && state.chassis->is_apart(motor)) return;
  state.use_motors();
}

/// Throws std::out_of_range.
MotorRef motor_of(RobotState& state, unsigned motor) {
  if (state.chassis) {
    ChassisWheel& w = state.chassis->motor(motor);
    return {w.wheel, w.motor, w.command};
  }
  return {state.wheels.at(motor), state.motor, state.commands.at(motor)};
}

}  // namespace

void Simulation::set_motor_duty(RobotIndex robot, unsigned motor, double duty) {
  RobotState& state = impl_->command(robot);
  const MotorRef ref = motor_of(state, motor);
  take_over(state, motor);
  ref.command = {std::clamp(duty, -1.0, 1.0) * ref.model.top, false};
}

void Simulation::set_motor_speed(RobotIndex robot, unsigned motor, double ticks_per_second) {
  RobotState& state = impl_->command(robot);
  const MotorRef ref = motor_of(state, motor);
  if (state.chassis && model(robot).drive.encoder_count() == 0) {
    throw std::out_of_range("robot: no encoder to control a motor's speed by");
  }
  take_over(state, motor);
  const double speed = ticks_per_second / ref.model.ticks_per_metre;
  ref.command = {std::clamp(speed, -ref.model.top, ref.model.top), true};
}

void Simulation::set_wheel(RobotIndex robot, unsigned motor, double radians_per_second) {
  const double ticks = model(robot).drive.ticks_per_revolution;
  set_motor_speed(robot, motor, radians_per_second * ticks / (2 * kPi));
}

void Simulation::set_motor_pid(RobotIndex robot, unsigned motor, int p, int i, int d) {
  motor_of(impl_->command(robot), motor)
      .wheel.set_gains({std::clamp(p, 0, 255), std::clamp(i, 0, 255), std::clamp(d, 0, 255)});
}

std::int64_t Simulation::encoder_ticks(RobotIndex robot, unsigned motor) const {
  const RobotState& state = impl_->at(robot);
  if (state.chassis) {
    const ChassisWheel& w = state.chassis->encoder(motor);
    return w.wheel.ticks(w.motor);
  }
  return state.wheels.at(motor).ticks(state.motor);
}

void Simulation::reset_encoder(RobotIndex robot, unsigned motor) {
  RobotState& state = impl_->command(robot);
  if (state.chassis) {
    ChassisWheel& w = state.chassis->encoder(motor);
    w.wheel.reset_ticks(w.motor);
    return;
  }
  state.wheels.at(motor).reset_ticks(state.motor);
}

void Simulation::set_twist(RobotIndex robot, const HolonomicTwist& twist) {
  if (!impl_->states.at(robot).chassis) {
    set_speed(robot, {twist.linear, twist.angular});
    return;
  }
  RobotState& state = impl_->command(robot);
  const Twist present = state.present();
  const bool was_by_motors = state.by_motors;
  state.clear_stall();
  state.by_motors = false;
  if (was_by_motors) state.chassis->release();
  state.chassis->set_twist(twist, present, state.controller);
}

HolonomicTwist Simulation::body_twist(RobotIndex robot) const {
  const RobotState& state = impl_->at(robot);
  return {state.driven.linear, state.driven_left, state.driven.angular};
}

void Simulation::set_steering(RobotIndex robot, double angle) {
  RobotState& state = impl_->command(robot);
  if (model(robot).drive.kind != DriveKind::Ackermann) {
    throw std::out_of_range("robot: no front wheels to steer");
  }
  state.use_motors();
  state.chassis->set_steering(angle);
}

double Simulation::altitude(RobotIndex robot) const {
  const RobotState& state = impl_->at(robot);
  return state.chassis ? state.chassis->altitude() : 0.0;
}

std::optional<double> Simulation::depth(RobotIndex robot) const {
  if (model(robot).drive.kind != DriveKind::Submarine) return std::nullopt;
  const Chassis& chassis = *impl_->at(robot).chassis;
  return chassis.highest() - chassis.altitude();
}

double Simulation::set_altitude(RobotIndex robot, double altitude) {
  RobotState& state = impl_->command(robot);
  if (!state.chassis) return 0.0;
  if (!state.has_left) state.chassis->set_altitude(altitude);
  return state.chassis->altitude();
}

double Simulation::steering(RobotIndex robot) const {
  const RobotState& state = impl_->at(robot);
  return state.chassis ? state.chassis->steering() : 0.0;
}

}  // namespace eyebridge::robot
