#pragma once

#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// The receiver of an infrared remote control. The backend owns it; any thread.
class Remote : public Device {
 public:
  /// The code of a key that was pressed since the last call, 1 … 255; 0 when none was. Never waits.
  /// Fails with Timeout or Disconnected on hardware.
  virtual Result<int> read() = 0;
};

}  // namespace eyebridge::hal
