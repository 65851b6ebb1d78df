#pragma once

#include <span>

#include "eyebridge/base/result.hpp"

namespace eyebridge::hal {

/// A scanning range sensor.
class Lidar {
 public:
  virtual ~Lidar() = default;

  /// Shape of the following scans: `field_of_view` radians centred on the front, `tilt` radians
  /// (positive down), `points` rays. Fails with OutOfRange.
  virtual Result<void> configure(double field_of_view, double tilt, int points) = 0;

  /// How many ranges a scan has.
  [[nodiscard]] virtual int points() const = 0;

  /// One scan, metres, left-most ray first, clockwise; a full circle starts straight behind.
  /// `ranges` has points() elements. "Nothing hit" reads as max_range().
  virtual Result<void> read(std::span<double> ranges) = 0;

  /// Metres.
  [[nodiscard]] virtual double max_range() const = 0;
};

}  // namespace eyebridge::hal
