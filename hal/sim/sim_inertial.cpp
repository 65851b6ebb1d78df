#include "sim/sim_inertial.hpp"

namespace eyebridge::hal {

Result<double> SimGyroscope::read() {
  return world_.sensed([&](auto& sim) { return sim.read_gyroscope(robot_); });
}

Result<Vec2> SimAccelerometer::read() {
  return world_.sensed([&](auto& sim) { return sim.read_accelerometer(robot_); });
}

}  // namespace eyebridge::hal
