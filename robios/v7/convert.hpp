#pragma once

#include <cmath>

#include "eyebridge/base/units.hpp"

namespace eyebridge::robios {

// RoBIOS speaks whole millimetres and degrees; these are the only places where they are made.

inline int to_mm(double metres) { return static_cast<int>(std::lround(m_to_mm(metres))); }
inline int to_deg(double radians) { return static_cast<int>(std::lround(rad_to_deg(radians))); }

/// Writes `value` where `out` points, if it points anywhere: programs pass NULL for what they do not
/// want.
inline void store(int* out, int value) {
  if (out != nullptr) *out = value;
}

}  // namespace eyebridge::robios
