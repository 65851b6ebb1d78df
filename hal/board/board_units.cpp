#include "board/board_units.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "eyebridge/base/units.hpp"
#include "opcodes.h"

namespace eyebridge::hal {
namespace {

std::int16_t to_word(double value) {
  constexpr double kLimit = std::numeric_limits<std::int16_t>::max();
  return static_cast<std::int16_t>(std::lround(std::clamp(value, -kLimit, kLimit)));
}

}  // namespace

int to_percent(const BoardMotorTable& table, double duty) {
  const double wanted = std::clamp(std::abs(duty), 0.0, 1.0);
  double given = wanted;
  if (table.duty.size() > 1) {
    const double at = wanted * static_cast<double>(table.duty.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), table.duty.size() - 2);
    const double part = at - static_cast<double>(below);
    given = table.duty[below] + part * (table.duty[below + 1] - table.duty[below]);
  }
  const int percent = static_cast<int>(std::lround(100 * std::clamp(given, 0.0, 1.0)));
  return duty < 0 ? -percent : percent;
}

int to_ticks_per_10ms(double ticks_per_second) {
  const double ticks = std::clamp<double>(ticks_per_second / 100, IO7_TICKS_FIRST, IO7_TICKS_LAST);
  return static_cast<int>(std::lround(ticks));
}

int to_servo_position(const BoardServoTable& table, double position) {
  const auto even = std::lround(255 * std::clamp(position, 0.0, 1.0));
  if (table.position.size() != 256) return static_cast<int>(even);
  return std::clamp(table.position[static_cast<std::size_t>(even)], 0, 255);
}

double to_metres(const BoardPsdTable& table, int raw) {
  const auto size = static_cast<int>(table.metres.size());
  const auto entry = [&](int i) { return table.metres[static_cast<std::size_t>(i)]; };
  raw = std::clamp(raw, 0, IO7_ADC_LAST);
  if (size > IO7_ADC_LAST) return entry(raw);
  const double at = static_cast<double>(raw) * (size - 1) / IO7_ADC_LAST;
  const int below = std::clamp(static_cast<int>(at), 0, std::max(size - 2, 0));
  const int above = std::min(below + 1, size - 1);
  const double part = at - below;
  // Beside "nothing is seen" there is no mean.
  if (entry(below) >= kBoardOutOfRange || entry(above) >= kBoardOutOfRange) {
    return entry(part < 0.5 ? below : above);
  }
  return entry(below) + part * (entry(above) - entry(below));
}

std::int16_t to_mm(double metres) { return to_word(m_to_mm(metres)); }
std::int16_t to_degrees(double radians) { return to_word(rad_to_deg(radians)); }
std::int16_t to_tenth_degrees(double radians) { return to_word(10 * rad_to_deg(radians)); }
std::int16_t to_centi_degrees(double radians) { return to_word(100 * rad_to_deg(radians)); }
double from_centi_degrees(double centi_degrees) { return deg_to_rad(centi_degrees / 100); }

Twist clamped(const Twist& twist, const BoardDriveShape& shape) {
  return {std::clamp(twist.linear, -shape.max_linear, shape.max_linear),
          std::clamp(twist.angular, -shape.max_angular, shape.max_angular)};
}

}  // namespace eyebridge::hal
