// The camera's, the kicker's, the steering's, and those that turn wheels or nothing.
#include <algorithm>
#include <cmath>
#include <set>

#include "eyebridge/robot/simulation.hpp"
#include "simulation_impl.hpp"

namespace eyebridge::robot {
namespace {

/// Share of the motor's full speed, -1 ... 1, that a wheel servo at `position` gives. Programs stop
/// it with 127 or 128, so that both count as the middle.
double duty_at(double position) {
  constexpr double kStep = 1.0 / 254;
  const double duty = 2 * position - 1;
  return std::fabs(duty) < 3 * kStep ? 0.0 : duty;
}

}  // namespace

std::vector<unsigned> RobotModel::servo_indices() const {
  std::set<unsigned> indices{0, 1};
  if (kicker) indices.insert(kicker->servo);
  if (drive.facts().steers_front()) indices.insert(drive.steering_servo);
  for (const ServoModel& own : servos) indices.insert(own.servo);
  return {indices.begin(), indices.end()};
}

void Simulation::set_servo(RobotIndex robot, unsigned servo, double position) {
  RobotDevices& devices = impl_->devices_of(robot);
  const double before = devices.servos.at(servo);
  devices.servos[servo] = std::clamp(position, 0.0, 1.0);
  const std::optional<KickerModel>& kicker = devices.model.kicker;
  if (kicker && strikes(*kicker, servo, before, devices.servos[servo])) {
    impl_->strike(robot, *kicker);
  }
  const DriveModel& drive = devices.model.drive;
  if (drive.steers(servo)) {
    set_steering(robot, (1.0 - 2 * devices.servos[servo]) * drive.max_steering);
  }
  for (const ServoModel& own : devices.model.servos) {
    if (own.servo != servo || own.wheel == ServoModel::Wheel::None) continue;
    set_motor_duty(robot, own.wheel == ServoModel::Wheel::Left ? 0 : 1,
                   duty_at(devices.servos[servo]));
  }
}

double Simulation::servo(RobotIndex robot, unsigned servo) const {
  const RobotDevices& devices = impl_->devices_of(robot);
  const DriveModel& drive = devices.model.drive;
  if (drive.steers(servo)) return (1.0 - steering(robot) / drive.max_steering) / 2;
  return devices.servos.at(servo);
}

}  // namespace eyebridge::robot
