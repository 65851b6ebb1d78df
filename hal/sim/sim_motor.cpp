#include "sim/sim_motor.hpp"

#include <cstdint>

namespace eyebridge::hal {
namespace {

constexpr const char* kName = "motor";

bool is_gain(int gain) { return gain >= 0 && gain <= 255; }

}  // namespace

SimMotor::SimMotor(SimWorld& world, robot::RobotIndex robot, unsigned index)
    : SimDevice(world, robot), index_(index) {}

Result<void> SimMotor::set_duty(double duty) {
  return require(duty >= -1.0 && duty <= 1.0, kName, duty, "a duty of -1 … 1").map([&] {
    world_.locked([&](auto& sim) { sim.set_motor_duty(robot_, index_, duty); });
  });
}

Result<void> SimMotor::set_speed(double ticks_per_second) {
  return require(std::isfinite(ticks_per_second), kName, ticks_per_second, "a finite speed")
      .map([&] {
        world_.locked([&](auto& sim) { sim.set_motor_speed(robot_, index_, ticks_per_second); });
      });
}

Result<void> SimMotor::set_pid(int p, int i, int d) {
  for (const int gain : {p, i, d}) {
    if (!is_gain(gain)) return require(false, kName, gain, "gains of 0 … 255");
  }
  world_.locked([&](auto& sim) { sim.set_motor_pid(robot_, index_, p, i, d); });
  return {};
}

SimEncoder::SimEncoder(SimWorld& world, robot::RobotIndex robot, unsigned index)
    : SimDevice(world, robot), index_(index) {}

Result<int> SimEncoder::read() {
  return world_.locked([&](auto& sim) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(sim.encoder_ticks(robot_, index_)));
  });
}

Result<void> SimEncoder::reset() {
  world_.locked([&](auto& sim) { sim.reset_encoder(robot_, index_); });
  return {};
}

}  // namespace eyebridge::hal
