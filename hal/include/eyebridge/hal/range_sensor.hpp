#pragma once

#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// One distance sensor (PSD) fixed to the robot.
///
/// The backend owns the sensor; a reference stays valid for as long as the backend does.
/// Any thread of the robot's program.
class RangeSensor : public Device {
 public:
  /// Distance from the sensor's face to the first surface along its axis, in metres.
  /// No surface within reach, or one that is too near, reads as `out_of_range()`, as it does on the
  /// robot.
  /// Fails with Timeout or Disconnected; never blocks longer than the link's timeout.
  virtual Result<double> read() = 0;

  /// The sensor's reading before linearisation: an ADC value on a board, millimetres in simulation.
  /// Fails as read() does.
  virtual Result<int> read_raw() = 0;

  /// What read() gives when nothing is within reach, in metres.
  [[nodiscard]] virtual double out_of_range() const = 0;
};

}  // namespace eyebridge::hal
