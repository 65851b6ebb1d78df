// Gyroscope and accelerometer: what the last step's motion is to a robot.
#include <cmath>

#include "simulation_impl.hpp"

namespace eyebridge::robot {

void Simulation::Impl::stray_gyroscope(RobotIndex robot) {
  RobotDevices& own = devices_of(robot);
  const double drift = own.model.gyroscope_error.drift;
  const double passed = static_cast<double>(steps - own.gyroscope_strayed) * settings.step;
  own.gyroscope_strayed = steps;
  // Parts of a random walk are independent, and their variances add up: how often it is asked for
  // makes no difference to where it goes.
  if (drift == 0.0 || passed == 0.0) return;
  own.gyroscope_stray += drift * std::sqrt(passed) * own.gyroscope.gaussian();
}

double Simulation::read_gyroscope(RobotIndex robot) {
  const double rate = twist(robot).angular;
  RobotDevices& devices = impl_->devices_of(robot);
  const GyroscopeError& error = devices.model.gyroscope_error;
  if (error.perfect()) return rate;
  impl_->stray_gyroscope(robot);
  return with_error(rate, error, devices.gyroscope) + devices.gyroscope_stray;
}

Vec2 Simulation::read_accelerometer(RobotIndex robot) {
  const RobotState& state = impl_->at(robot);
  const HolonomicTwist& now = state.driven;
  const HolonomicTwist& before = state.driven_before;
  const double dt = impl_->settings.step;
  const Vec2 felt{(now.linear - before.linear) / dt - now.lateral * now.angular,
                  (now.lateral - before.lateral) / dt + now.linear * now.angular};
  RobotDevices& devices = impl_->devices_of(robot);
  const AccelerometerError& error = devices.model.accelerometer_error;
  if (error.perfect()) return felt;
  const double x = with_error(felt.x, error, devices.accelerometer);
  return {x, with_error(felt.y, error, devices.accelerometer)};
}

}  // namespace eyebridge::robot
