#pragma once

#include <chrono>

#include "eyebridge/base/units.hpp"

namespace eyebridge::camera::testing {

/// How long a live camera may take for a frame, on a guest kernel beside a compiler.
inline constexpr Time kPatience = std::chrono::seconds(3);

}  // namespace eyebridge::camera::testing
