#pragma once

#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// Acceleration in the plane of the floor. The backend owns it; any thread.
class Accelerometer : public Device {
 public:
  /// Metres per second squared in the robot's frame, x forward, y left; gravity is not in it. Fails
  /// with Timeout or Disconnected on hardware.
  virtual Result<Vec2> read() = 0;
};

}  // namespace eyebridge::hal
