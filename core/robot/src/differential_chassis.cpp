#include "differential_chassis.hpp"

namespace eyebridge::robot {

std::unique_ptr<Chassis> make_differential(const RobotModel& robot, const MotorModel& motor,
                                           double /*water*/) {
  return std::make_unique<DifferentialChassis>(robot.drive, motor);
}

}  // namespace eyebridge::robot
