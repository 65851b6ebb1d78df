#pragma once

#include "eyebridge/hal/analog_inputs.hpp"

namespace eyebridge::hal {

/// The analog inputs of a simulated robot: a battery that never empties, a microphone in a silent
/// room (the middle of its range), and pins that nothing is connected to (0).
class SimAnalog final : public AnalogInputs {
 public:
  /// Of the battery, volts, 0 … kVoltsAtMost.
  explicit SimAnalog(double supply_voltage) : supply_voltage_(supply_voltage) {}

  /// What channel 0 reads as kMost, as on our boards (firmware-stubs/pins).
  static constexpr double kVoltsAtMost = 20.0;

  Result<int> read(int channel) override;
  Result<double> supply_voltage() override { return supply_voltage_; }

 private:
  const double supply_voltage_;
};

}  // namespace eyebridge::hal
