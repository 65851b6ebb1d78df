#include "sim/sim_switch_sensor.hpp"

namespace eyebridge::hal {

SimProximity::SimProximity(SimWorld& world, robot::RobotIndex robot, std::size_t index)
    : SimDevice(world, robot), index_(index) {}

Result<bool> SimProximity::read() {
  return world_.sensed([&](auto& sim) { return sim.read_proximity(robot_, index_); });
}

SimBumper::SimBumper(SimWorld& world, robot::RobotIndex robot, std::size_t index)
    : SimDevice(world, robot), index_(index) {}

Result<bool> SimBumper::read() {
  return world_.sensed([&](auto& sim) { return sim.read_bumper(robot_, index_); });
}

}  // namespace eyebridge::hal
