#pragma once

#include <limits>

namespace eyebridge::world {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// A ray as the quick look at a block sees it: from (x, y), relative to the grid's origin.
struct RayQuery {
  float x, y, dx, dy;
  float reach;   ///< Farther hits do not matter.
  float margin;  ///< What rounding may do to a distance, metres.
};

}  // namespace eyebridge::world
