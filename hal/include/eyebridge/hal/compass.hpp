#pragma once

#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// Heading in the world. The backend owns it; any thread.
class Compass : public Device {
 public:
  /// Radians counter-clockwise from the world's +x axis, (-pi, pi]. Fails with Timeout or
  /// Disconnected on hardware.
  virtual Result<double> read() = 0;
};

}  // namespace eyebridge::hal
