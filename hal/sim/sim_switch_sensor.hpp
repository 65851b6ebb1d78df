#pragma once

#include "eyebridge/hal/switch_sensor.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// An infrared proximity switch of a simulated robot.
class SimProximity final : public SwitchSensor, private SimDevice {
 public:
  /// `index` into the model's proximity_sensors.
  SimProximity(SimWorld& world, robot::RobotIndex robot, std::size_t index);
  Result<bool> read() override;

 private:
  const std::size_t index_;
};

/// A bumper of a simulated robot.
class SimBumper final : public SwitchSensor, private SimDevice {
 public:
  /// `index` into the model's bumpers.
  SimBumper(SimWorld& world, robot::RobotIndex robot, std::size_t index);
  Result<bool> read() override;

 private:
  const std::size_t index_;
};

}  // namespace eyebridge::hal
