#include "sim/sim_range_sensor.hpp"

#include <cmath>

#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {

SimRangeSensor::SimRangeSensor(SimWorld& world, robot::RobotIndex robot, std::size_t index)
    : SimDevice(world, robot), index_(index), out_of_range_(world.locked([&](auto& sim) {
        return sim.model(robot).range_sensors[index].out_of_range;
      })) {}

Result<double> SimRangeSensor::read() {
  return world_.sensed([&](auto& sim) { return sim.read_range(robot_, index_); });
}

Result<int> SimRangeSensor::read_raw() {
  return read().map([](double range) { return static_cast<int>(std::lround(m_to_mm(range))); });
}

}  // namespace eyebridge::hal
