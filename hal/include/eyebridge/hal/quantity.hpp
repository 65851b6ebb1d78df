#pragma once

#include <cstddef>
#include <cstdint>

namespace eyebridge::hal {

/// What the numbers are that a call gives or takes, in their order; SI units.
enum class Quantity : std::uint8_t {
  Pose,         ///< By odometry: x, y (m), heading (rad).
  Speed,        ///< Measured: m/s, rad/s.
  WantedSpeed,  ///< Asked for: m/s, rad/s.
  Goal,         ///< Distance (m), angle (rad), speed (m/s; of a turn rad/s).
  Progress,     ///< A DriveProgress, metres to go, whether the left and the right wheel is stalled.
  Duty,         ///< -1 … 1.
  TickRate,     ///< Asked for: ticks/s.
  Gains,        ///< P, I, D, 0 … 255.
  Ticks,        ///< Of an encoder.
  Position,     ///< Of a servo, 0 … 1.
  Distance,     ///< m.
  Raw,          ///< As the sensor gives it, without unit.
  Switch,       ///< 0 or 1: something is near, or touches.
  Nearest,      ///< Of a scan: range (m) and bearing (rad, left positive) of its nearest point.
  Heading,      ///< rad.
  TurnRate,     ///< rad/s.
  Acceleration,  ///< Forward, left (m/s²).
  Level,         ///< Of a line, as read: 0 or 1.
  WrittenLevel,  ///< Of a line, as written: 0 or 1.
  Lines,         ///< All at once, line 1 is bit 0.
  Count,         ///< Of an analog input, 0 … 4095.
  Voltage,       ///< V.
  RemoteCode,    ///< Of the robot's own receiver, 1 … 255.
};
inline constexpr std::size_t kQuantityCount = static_cast<std::size_t>(Quantity::RemoteCode) + 1;

}  // namespace eyebridge::hal
