#include "eyebridge/pins/robot_pins.hpp"

#include <algorithm>

#include "eyebridge/base/units.hpp"
#include "eyebridge/pins/psd_table.hpp"

namespace eyebridge::pins {
namespace {

constexpr std::uint16_t kBatteryCv = 740;
constexpr double kVoltsAtTopAdc = 20.0;  // analog 0
constexpr std::uint16_t kQuiet = 2048;   // the microphone
constexpr unsigned kWheels = 2;
constexpr double kShortestPulse = 1000;  // microseconds
constexpr double kPulseRange = 1000;

}  // namespace

eb_drive_config drive_config(const robot::DriveModel& model, std::uint32_t stall_timeout_us) {
  const double ticks_per_metre = model.ticks_per_revolution / (kPi * model.wheel_diameter);
  eb_drive_config drive{};
  drive.ticks_per_metre = static_cast<float>(ticks_per_metre);
  drive.wheel_base = static_cast<float>(model.wheel_base);
  drive.max_linear = static_cast<float>(model.max_linear);
  drive.max_angular = static_cast<float>(model.max_angular);
  drive.linear_acceleration = static_cast<float>(model.linear_acceleration);
  drive.angular_acceleration = static_cast<float>(model.angular_acceleration);
  drive.motor_lag = static_cast<float>(model.motor_time_constant);
  drive.full_ticks =
      static_cast<float>(model.max_wheel_speed / (2 * kPi) * model.ticks_per_revolution * 0.01);
  drive.stall_timeout_us = stall_timeout_us;
  return drive;
}

void read_pins(robot::Simulation& simulation, robot::RobotIndex robot, eb_pins& pins) {
  const robot::RobotModel& model = simulation.model(robot);
  for (unsigned wheel = 0; wheel < kWheels; ++wheel) {
    // The counters wrap: only the low bits are there.
    pins.encoder[wheel] =
        static_cast<std::uint16_t>(simulation.encoder_ticks(robot, wheel) & 0xFFFF);
  }
  std::ranges::fill(pins.psd, static_cast<std::uint16_t>(EB_PSD_ABSENT));
  for (std::size_t i = 0; i < model.range_sensors.size(); ++i) {
    const int id = model.range_sensors[i].id;
    if (id < 1 || id > EB_PSDS) continue;
    const double range = simulation.read_range(robot, i);
    const bool reached = range < model.range_sensors[i].out_of_range;
    pins.psd[id - 1] = reached ? psd_raw(range) : std::uint16_t{0};
  }
  unsigned port = 0;
  std::uint16_t levels = 0;
  const auto connect = [&](bool level) {
    if (port < EB_PORTS) levels = static_cast<std::uint16_t>(levels | (level ? 1U << port : 0U));
    ++port;
  };
  for (std::size_t i = 0; i < model.bumpers.size(); ++i) {
    connect(simulation.read_bumper(robot, i));
  }
  for (std::size_t i = 0; i < model.proximity_sensors.size(); ++i) {
    connect(simulation.read_proximity(robot, i));
  }
  pins.digital_in = levels;
  pins.digital_driven = static_cast<std::uint16_t>((1U << std::min<unsigned>(port, EB_PORTS)) - 1U);
  pins.supply_cv = kBatteryCv;
  pins.analog[0] = static_cast<std::uint16_t>(kBatteryCv / 100.0 / kVoltsAtTopAdc * 4095);
  pins.analog[8] = kQuiet;
}

void obey_pins(const eb_pins& pins, robot::Simulation& simulation, robot::RobotIndex robot) {
  for (unsigned wheel = 0; wheel < kWheels; ++wheel) {
    simulation.set_motor_duty(robot, wheel, static_cast<double>(pins.duty[wheel]) / EB_DUTY_FULL);
  }
  for (unsigned servo = 0; servo < EB_SERVOS; ++servo) {
    if (pins.servo_us[servo] == 0) continue;
    simulation.set_servo(robot, servo, (pins.servo_us[servo] - kShortestPulse) / kPulseRange);
  }
}

}  // namespace eyebridge::pins
