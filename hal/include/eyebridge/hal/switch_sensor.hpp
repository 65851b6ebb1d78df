#pragma once

#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// A sensor that says yes or no: an infrared proximity switch or a bumper. The
/// backend owns it; any thread.
class SwitchSensor : public Device {
 public:
  /// True when something is near, or touches. Fails with Timeout or Disconnected.
  virtual Result<bool> read() = 0;
};

}  // namespace eyebridge::hal
