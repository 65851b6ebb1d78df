#pragma once

#include "eyebridge/hal/accelerometer.hpp"
#include "eyebridge/hal/analog_inputs.hpp"
#include "eyebridge/hal/compass.hpp"
#include "eyebridge/hal/gyroscope.hpp"
#include "eyebridge/hal/range_matrix.hpp"
#include "eyebridge/hal/range_sensor.hpp"
#include "eyebridge/hal/switch_sensor.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// One distance sensor of a simulated robot; its raw reading is millimetres.
class SimRangeSensor final : public RangeSensor, private SimNumbered {
 public:
  SimRangeSensor(SimWorld& world, robot::RobotIndex robot, std::size_t index);

  Result<double> read() override;
  Result<int> read_raw() override;
  [[nodiscard]] double out_of_range() const override { return out_of_range_; }

 private:
  const double out_of_range_;
};

/// One matrix of ranges of a simulated robot.
class SimRangeMatrix final : public RangeMatrix, private SimNumbered {
 public:
  SimRangeMatrix(SimWorld& world, robot::RobotIndex robot, std::size_t index);

  Result<Ranges> read() override;
  [[nodiscard]] double out_of_range() const override { return out_of_range_; }

 private:
  const double out_of_range_;
};

/// An infrared proximity switch of a simulated robot.
class SimProximity final : public SwitchSensor, private SimNumbered {
 public:
  using SimNumbered::SimNumbered;
  Result<bool> read() override;
};

/// A bumper of a simulated robot.
class SimBumper final : public SwitchSensor, private SimNumbered {
 public:
  using SimNumbered::SimNumbered;
  Result<bool> read() override;
};

/// The compass of a simulated robot.
class SimCompass final : public Compass, private SimDevice {
 public:
  using SimDevice::SimDevice;
  Result<double> read() override;
};

/// The gyroscope of a simulated robot.
class SimGyroscope final : public Gyroscope, private SimDevice {
 public:
  using SimDevice::SimDevice;
  Result<double> read() override;
};

/// The accelerometer of a simulated robot.
class SimAccelerometer final : public Accelerometer, private SimDevice {
 public:
  using SimDevice::SimDevice;
  Result<Vec2> read() override;
};

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
