#pragma once

#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// Rate of turn about the upright axis. The backend owns it; any thread.
class Gyroscope : public Device {
 public:
  /// Radians per second, counter-clockwise positive; any number, for its bias may stray. Fails with
  /// Timeout or Disconnected on hardware.
  virtual Result<double> read() = 0;
};

}  // namespace eyebridge::hal
