#include "sim/sim_actuators.hpp"

#include <cstdint>

#include "arguments/arguments.hpp"

namespace eyebridge::hal {

Result<void> SimMotor::set_duty(double duty) {
  return check_duty(duty).map(
      [&] { world_.locked([&](auto& sim) { sim.set_motor_duty(robot_, index_, duty); }); });
}

Result<void> SimMotor::set_speed(double ticks_per_second) {
  const auto encoders = [&](auto& sim) { return sim.model(robot_).drive.encoder_count(); };
  if (world_.locked(encoders) == 0) {
    return fail(Errc::Unsupported, "a thruster has no encoder to control its speed by");
  }
  return check_motor_speed(ticks_per_second).map([&] {
    world_.locked([&](auto& sim) { sim.set_motor_speed(robot_, index_, ticks_per_second); });
  });
}

Result<void> SimMotor::set_pid(int p, int i, int d) {
  return check_gains(p, i, d).map(
      [&] { world_.locked([&](auto& sim) { sim.set_motor_pid(robot_, index_, p, i, d); }); });
}

Result<int> SimEncoder::read() {
  return world_.sensed([&](auto& sim) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(sim.encoder_ticks(robot_, index_)));
  });
}

Result<void> SimEncoder::reset() {
  world_.locked([&](auto& sim) { sim.reset_encoder(robot_, index_); });
  return {};
}

Result<void> SimServo::set(double position) {
  return check_servo_position(position).map(
      [&] { world_.locked([&](auto& sim) { sim.set_servo(robot_, index_, position); }); });
}

}  // namespace eyebridge::hal
