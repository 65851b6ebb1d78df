#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <tl/expected.hpp>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/mapping/raster.hpp"

namespace eyebridge::planning {

/// Which cells the centre of a robot may not be in: nonzero is blocked. Outside of the grid is
/// blocked, too. A robot is a point here: widen obstacles with widened() first.
using BlockedRaster = mapping::Raster<std::uint8_t>;

/// A way from a start to a goal.
struct Path {
  std::vector<Vec2> points;  ///< Way-points with straight lines between them, metres; at least one.
  double length = 0.0;       ///< Of all lines, metres.
  std::size_t expanded = 0;  ///< Measure of the work: cells expanded, nodes grown or steps taken.
};

/// Why there is no path.
enum class NoPath {
  StartOutside,  ///< Outside of the grid, or not finite.
  GoalOutside,   ///< Outside of the grid, or not finite.
  StartBlocked,
  GoalBlocked,
  Unreachable,   ///< Proven: all that the start reaches was searched.
  LocalMinimum,  ///< A potential field got stuck; there may be a path.
  BudgetSpent,   ///< Not found with the samples or steps allowed; there may be one.
};

/// One line of English for a log.
const char* to_text(NoPath reason);

/// A path, or why there is none.
using Planned = tl::expected<Path, NoPath>;

/// Length of the straight lines between `points`, metres; 0 for fewer than two.
double length_of(const std::vector<Vec2>& points);

/// The cells of a start and a goal.
struct Ends {
  mapping::Cell start;
  mapping::Cell goal;
};

/// Where `start` and `goal`, metres, lie; or what is wrong with them, the start's faults first.
/// Any number will do, NaN as well.
tl::expected<Ends, NoPath> ends_of(const BlockedRaster& blocked, Vec2 start, Vec2 goal);

/// Whether `point` is finite and within the grid.
bool is_within(const mapping::GridGeometry& geometry, Vec2 point);

}  // namespace eyebridge::planning
