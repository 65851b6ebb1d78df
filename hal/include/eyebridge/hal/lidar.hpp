#pragma once

#include <span>

#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// How a lidar scans.
struct LidarShape {
  double field_of_view = 0.0;  ///< Radians centred on the front, more than 0, at most 2 pi.
  double tilt = 0.0;           ///< Of the scan's plane, radians, -pi/2 … pi/2, positive down.
  int points = 0;              ///< Rays of a scan, at least 1; a single one looks ahead.

  friend bool operator==(const LidarShape&, const LidarShape&) = default;
};

/// A scanning range sensor. At first it has the shape that its robot's model says.
///
/// The backend owns it; any thread. A scan is of the shape that is set when it starts, so threads
/// that set different shapes have to agree among themselves.
class Lidar : public Device {
 public:
  /// Shape of the following scans: `field_of_view` radians centred on the front, `tilt` radians
  /// (positive down), `points` rays; a single ray looks ahead. Fails with OutOfRange for a shape
  /// that LidarShape excludes or with more points than the device has, and leaves the old one.
  virtual Result<void> configure(double field_of_view, double tilt, int points) = 0;

  /// The shape of the following scans: configure() takes it back unchanged.
  [[nodiscard]] virtual LidarShape shape() const = 0;
  /// How many ranges a scan has: shape().points.
  [[nodiscard]] int points() const { return shape().points; }

  /// One scan, metres, 0 … max_range(), left-most ray first, clockwise; a full circle starts
  /// straight behind. `ranges` has points() elements, else OutOfRange. Ranges are along the tilted
  /// rays; "nothing hit" reads as max_range(), and so does all that is farther: ranges are clamped
  /// without an error. Fails with Timeout or Disconnected on hardware.
  virtual Result<void> read(std::span<double> ranges) = 0;

  /// Metres.
  [[nodiscard]] virtual double max_range() const = 0;
};

}  // namespace eyebridge::hal
