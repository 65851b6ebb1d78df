#pragma once

#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// The analog inputs of a robot, channels 0 … 8: 0 is the supply, 8 the microphone.
///
/// The backend owns them; any thread. Fails with Timeout or Disconnected on hardware.
class AnalogInputs : public Device {
 public:
  static constexpr int kSupply = 0;
  static constexpr int kMicrophone = 8;
  static constexpr int kLast = 8;
  static constexpr int kMost = 4095;  ///< The converter has 12 bits.

  /// Value of the converter, 0 … kMost. OutOfRange for another channel; Unsupported where nothing
  /// measures this one.
  virtual Result<int> read(int channel) = 0;
  /// Supply voltage, volts.
  virtual Result<double> supply_voltage() = 0;
};

}  // namespace eyebridge::hal
