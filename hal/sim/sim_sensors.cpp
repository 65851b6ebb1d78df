#include "sim/sim_sensors.hpp"

#include <cmath>

#include "arguments/arguments.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

constexpr int kSilence = 2048;

}  // namespace

SimRangeSensor::SimRangeSensor(SimWorld& world, robot::RobotIndex robot, std::size_t index)
    : SimNumbered(world, robot, index), out_of_range_(world.locked([&](auto& sim) {
        return sim.model(robot).range_sensors[index].out_of_range;
      })) {}

Result<double> SimRangeSensor::read() {
  return world_.sensed([&](auto& sim) { return sim.read_range(robot_, index_); });
}

Result<int> SimRangeSensor::read_raw() {
  return read().map([](double range) { return static_cast<int>(std::lround(m_to_mm(range))); });
}

SimRangeMatrix::SimRangeMatrix(SimWorld& world, robot::RobotIndex robot, std::size_t index)
    : SimNumbered(world, robot, index), out_of_range_(world.locked([&](auto& sim) {
        return sim.model(robot).range_matrices[index].out_of_range;
      })) {
  static_assert(kSize == robot::kMatrixSize);
}

Result<RangeMatrix::Ranges> SimRangeMatrix::read() {
  Ranges ranges{};
  return world_
      .sensed_all(ranges,
                  [&](auto& sim) -> Result<void> {
                    sim.read_range_matrix(robot_, index_, ranges);
                    return {};
                  })
      .map([&] { return ranges; });
}

Result<bool> SimProximity::read() {
  return world_.sensed([&](auto& sim) { return sim.read_proximity(robot_, index_); });
}

Result<bool> SimBumper::read() {
  return world_.sensed([&](auto& sim) { return sim.read_bumper(robot_, index_); });
}

Result<double> SimCompass::read() {
  return world_.sensed([&](auto& sim) { return sim.read_compass(robot_); });
}

Result<double> SimGyroscope::read() {
  return world_.sensed([&](auto& sim) { return sim.read_gyroscope(robot_); });
}

Result<Vec2> SimAccelerometer::read() {
  return world_.sensed([&](auto& sim) { return sim.read_accelerometer(robot_); });
}

Result<int> SimAnalog::read(int channel) {
  return check_channel(channel).map([&] {
    if (channel == kMicrophone) return kSilence;
    return channel == kSupply ? static_cast<int>(supply_voltage_ / kVoltsAtMost * kMost) : 0;
  });
}

}  // namespace eyebridge::hal
