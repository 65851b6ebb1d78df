#include "sim/sim_servo.hpp"

#include "arguments/arguments.hpp"

namespace eyebridge::hal {

SimServo::SimServo(SimWorld& world, robot::RobotIndex robot, unsigned index)
    : SimDevice(world, robot), index_(index) {}

Result<void> SimServo::set(double position) {
  return check_servo_position(position).map(
      [&] { world_.locked([&](auto& sim) { sim.set_servo(robot_, index_, position); }); });
}

}  // namespace eyebridge::hal
