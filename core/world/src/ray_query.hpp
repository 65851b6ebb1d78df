#pragma once

#include <cstddef>
#include <limits>

namespace eyebridge::world {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// A ray on its way through a grid. Ranges are metres from the ray's origin.
struct RayState {
  double next[2];     ///< Range to the next border of columns, and of rows; or infinite.
  double between[2];  ///< Range from one such border to the next.
  double limit;       ///< Range at which it leaves the grid.
  std::size_t cell;
  std::size_t step[2];  ///< To the cell beyond the next border; modulo 2^64 when it is before.
};

}  // namespace eyebridge::world
