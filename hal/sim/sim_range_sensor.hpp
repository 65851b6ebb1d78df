#pragma once

#include "eyebridge/hal/range_sensor.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// One distance sensor of a simulated robot; its raw reading is millimetres.
class SimRangeSensor final : public RangeSensor, private SimDevice {
 public:
  /// `index` into the model's range_sensors.
  SimRangeSensor(SimWorld& world, robot::RobotIndex robot, std::size_t index);

  Result<double> read() override;
  Result<int> read_raw() override;
  [[nodiscard]] double out_of_range() const override { return out_of_range_; }

 private:
  const std::size_t index_;
  const double out_of_range_;
};

}  // namespace eyebridge::hal
