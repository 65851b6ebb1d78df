#pragma once

#include "eyebridge/hal/accelerometer.hpp"
#include "eyebridge/hal/gyroscope.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// The gyroscope of a simulated robot.
class SimGyroscope final : public Gyroscope, private SimDevice {
 public:
  using SimDevice::SimDevice;
  Result<double> read() override;
};

/// The accelerometer of a simulated robot.
class SimAccelerometer final : public Accelerometer, private SimDevice {
 public:
  using SimDevice::SimDevice;
  Result<Vec2> read() override;
};

}  // namespace eyebridge::hal
