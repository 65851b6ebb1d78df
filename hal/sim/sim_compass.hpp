#pragma once

#include "eyebridge/hal/compass.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// The compass of a simulated robot.
class SimCompass final : public Compass, private SimDevice {
 public:
  using SimDevice::SimDevice;
  Result<double> read() override;
};

}  // namespace eyebridge::hal
