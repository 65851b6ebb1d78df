#pragma once

#include <limits>

namespace eyebridge::mapping {

inline constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace eyebridge::mapping
