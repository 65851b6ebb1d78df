#pragma once

#include <cstddef>
#include <limits>

namespace eyebridge::world {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// A ray as the quick look at a block sees it: from (x, y), relative to the grid's origin, metres.
struct RayQuery {
  float x, y, dx, dy;
  float margin;  ///< What rounding may do to a distance, metres.
};

/// How a ray's walk through a grid starts. Ranges are metres from the ray's origin.
struct RayStart {
  double cells_x, cells_y;  ///< Range from one border of columns, or of rows, to the next.
  double next_x, next_y;    ///< Range to the first of those borders; infinite for parallel rays.
  double entry;             ///< Range at which it enters the grid; 0 from inside.
  double limit;             ///< No hit counts from here on.
  std::ptrdiff_t cell;      ///< Where it enters; rays that miss the grid start in an empty cell.
  float x, y;               ///< Same place, relative to the grid's origin.
};

}  // namespace eyebridge::world
