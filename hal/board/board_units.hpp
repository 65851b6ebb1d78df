#pragma once

#include <cstdint>

#include "board/board_tables.hpp"
#include "eyebridge/base/pose.hpp"

namespace eyebridge::hal {

// All that stands between our units and a board's, in one place. Arguments are finite; what is out
// of a board's range is clamped.

/// Percent -100 … 100 for a duty of -1 … 1: through the motor's table, sign kept.
int to_percent(const BoardMotorTable& table, double duty);
/// Encoder ticks per 10 ms, -128 … 127, for ticks per second.
int to_ticks_per_10ms(double ticks_per_second);
/// 0 … 255 for a servo's position of 0 … 1.
int to_servo_position(const BoardServoTable& table, double position);
/// Metres for a raw reading of 0 … 4095. The table is not empty.
double to_metres(const BoardPsdTable& table, int raw);
/// Millimetres, degrees, 0.1 and 0.01 degrees, to the nearest, as 16 bits.
std::int16_t to_mm(double metres);
std::int16_t to_degrees(double radians);
std::int16_t to_tenth_degrees(double radians);
std::int16_t to_centi_degrees(double radians);
/// And back.
double from_centi_degrees(double centi_degrees);
/// `twist`, not faster than the drive can.
Twist clamped(const Twist& twist, const BoardDriveShape& shape);

}  // namespace eyebridge::hal
