#pragma once

#include <string>

#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// The I/O board of a robot, as a thing of its own. The backend owns it; any thread.
class IoBoard : public Device {
 public:
  /// Version of its firmware, printable characters, as the board says it. Fails with Timeout or
  /// Disconnected.
  virtual Result<std::string> version() = 0;
};

}  // namespace eyebridge::hal
