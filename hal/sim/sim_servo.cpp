#include "sim/sim_servo.hpp"

namespace eyebridge::hal {

SimServo::SimServo(SimWorld& world, robot::RobotIndex robot, unsigned index)
    : SimDevice(world, robot), index_(index) {}

Result<void> SimServo::set(double position) {
  return require(position >= 0.0 && position <= 1.0, "servo", position, "a position of 0 … 1")
      .map([&] { world_.locked([&](auto& sim) { sim.set_servo(robot_, index_, position); }); });
}

}  // namespace eyebridge::hal
