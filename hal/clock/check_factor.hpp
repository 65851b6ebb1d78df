#pragma once

#include <fmt/format.h>

#include "eyebridge/base/result.hpp"

namespace eyebridge::hal {

/// What the setting `factor` may be.
inline Result<void> check_factor(double factor) {
  constexpr double kLeast = 0.001;
  constexpr double kMost = 1e6;
  if (factor >= kLeast && factor <= kMost) return {};
  return fail(
      Errc::OutOfRange,
      fmt::format("found a factor of {:g} on time, expected {:g} ... {:g}", factor, kLeast, kMost));
}

}  // namespace eyebridge::hal
