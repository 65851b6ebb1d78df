#include "arguments/arguments.hpp"

#include <cmath>

#include <fmt/format.h>

#include "eyebridge/hal/analog_inputs.hpp"
#include "eyebridge/hal/digital_lines.hpp"

namespace eyebridge::hal {

Result<void> require(bool good, const char* device, double value, const char* expected) {
  if (good) return {};
  return fail(Errc::OutOfRange, fmt::format("{}: got {}, expected {}", device, value, expected));
}

Result<void> check_speed(const Twist& twist) {
  // A sum is finite only if its parts are: one check for both.
  const double sum = twist.linear + twist.angular;
  return require(std::isfinite(sum), "drive", sum, "a finite speed");
}

Result<void> check_goal(const DriveGoal& goal) {
  return require(std::isfinite(goal.distance), "drive", goal.distance, "a finite distance")
      .and_then(
          [&] { return require(std::isfinite(goal.angle), "drive", goal.angle, "a finite angle"); })
      .and_then([&] {
        return require(std::isfinite(goal.speed) && goal.speed >= 0.0, "drive", goal.speed,
                       "a speed of at least 0");
      });
}

Result<void> check_pose(const Pose& pose) {
  const double sum = pose.x + pose.y + pose.theta;
  return require(std::isfinite(sum), "drive", sum, "a finite pose");
}

Result<void> check_duty(double duty) {
  return require(duty >= -1.0 && duty <= 1.0, "motor", duty, "a duty of -1 … 1");
}

Result<void> check_motor_speed(double ticks_per_second) {
  return require(std::isfinite(ticks_per_second), "motor", ticks_per_second, "a finite speed");
}

Result<void> check_gains(int p, int i, int d) {
  for (const int gain : {p, i, d}) {
    if (gain < 0 || gain > 255) return require(false, "motor", gain, "gains of 0 … 255");
  }
  return {};
}

Result<void> check_servo_position(double position) {
  return require(position >= 0.0 && position <= 1.0, "servo", position, "a position of 0 … 1");
}

Result<void> check_scan_size(std::size_t ranges, int points) {
  if (ranges == static_cast<std::size_t>(points)) return {};
  return fail(Errc::OutOfRange,
              fmt::format("lidar: got room for {} ranges, expected {}", ranges, points));
}

Result<void> check_line(int line) {
  return require(line >= 1 && line <= DigitalLines::kCount, "digital", line, "a line, 1 … 16");
}

Result<void> check_channel(int channel) {
  return require(channel >= 0 && channel <= AnalogInputs::kLast, "analog", channel,
                 "a channel, 0 … 8");
}

}  // namespace eyebridge::hal
