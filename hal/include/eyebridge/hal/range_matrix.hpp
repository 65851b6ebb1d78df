#pragma once

#include <array>
#include <cstddef>

#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// One matrix of ranges by time of flight, fixed to the robot: rows of zones, each a cone.
///
/// The backend owns it; any thread.
class RangeMatrix : public Device {
 public:
  /// Rows, and zones of a row.
  static constexpr std::size_t kSize = 8;
  /// Of all zones, radians, to either side and up and down.
  static constexpr double kFieldOfView = 0.7853981633974483;
  static constexpr int kLastId = 8;
  /// Metres, the top row first, each from the left.
  using Ranges = std::array<double, kSize * kSize>;

  /// The nearest surface in each zone's cone, metres along the axis of the sensor: all zones that
  /// see a wall straight ahead read the same. Nothing within reach reads as out_of_range(). Fails
  /// with Timeout or Disconnected; never blocks longer than the link's timeout.
  virtual Result<Ranges> read() = 0;

  /// What read() gives when nothing is within reach, in metres.
  [[nodiscard]] virtual double out_of_range() const = 0;
};

}  // namespace eyebridge::hal
