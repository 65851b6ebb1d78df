#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "eyebridge/base/colour.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::robios {

// RoBIOS speaks whole millimetres and degrees; these are the only places where they are made.

/// To the nearest whole number; what an int cannot hold becomes the largest or smallest int.
inline int to_whole(double value) {
  constexpr double kMost = std::numeric_limits<int>::max();
  constexpr double kLeast = std::numeric_limits<int>::min();
  // As std::lround(), which is a call: halves go away from zero. The number is the one below 0.5.
  constexpr double kHalf = 0.49999999999999994;
  const double whole = std::clamp(value, kLeast, kMost);
  return static_cast<int>(static_cast<std::int64_t>(whole + std::copysign(kHalf, whole)));
}
inline int to_mm(double metres) { return to_whole(m_to_mm(metres)); }
inline int to_deg(double radians) { return to_whole(rad_to_deg(radians)); }

/// RoBIOS keeps a colour in an int: 0xRRGGBB.
inline Rgb to_rgb(int colour) {
  const auto bits = static_cast<unsigned>(colour);
  return {static_cast<std::uint8_t>((bits >> 16) & 0xFF),
          static_cast<std::uint8_t>((bits >> 8) & 0xFF), static_cast<std::uint8_t>(bits & 0xFF)};
}

/// Writes `value` where `out` points, if it points anywhere: programs pass NULL for what they do
/// not want.
inline void store(int* out, int value) {
  if (out != nullptr) *out = value;
}

}  // namespace eyebridge::robios
