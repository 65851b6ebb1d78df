#pragma once

#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// One servo. The backend owns it; any thread.
class Servo : public Device {
 public:
  /// Turns to `position` 0 … 1 and returns at once; 0.5 is the middle. Another position is
  /// OutOfRange. Fails with Timeout or Disconnected on hardware.
  virtual Result<void> set(double position) = 0;
};

}  // namespace eyebridge::hal
