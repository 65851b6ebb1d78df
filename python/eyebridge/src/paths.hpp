#pragma once

#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "checks.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"
#include "eyebridge/planning/clearance.hpp"
#include "eyebridge/planning/path.hpp"

namespace eyebridge::python {

using Point = std::pair<double, double>;

inline Vec2 vec(const Point& point) { return {point.first, point.second}; }

/// Where the centre of a robot of `radius` may not be. Raises ValueError.
inline planning::BlockedRaster blocked_of(const mapping::OccupancyGrid& grid, double radius,
                                          bool unknown_blocks) {
  using mapping::CellState;
  if (!(radius >= 0)) refuse("radius", radius, "0 m or more");
  const planning::BlockedRaster blocked =
      unknown_blocks ? mapping::cells_in(grid, {CellState::Occupied, CellState::Unknown})
                     : mapping::cells_in(grid, {CellState::Occupied});
  return planning::widened(planning::clearance_of(blocked), radius);
}

/// One row a point.
inline pybind11::array_t<double> rows_of(const std::vector<Vec2>& points) {
  std::vector<double> rows;
  for (const Vec2 point : points) rows.insert(rows.end(), {point.x, point.y});
  return array_of(std::move(rows)).reshape({-1, 2});
}

/// Nothing where there is no way, ValueError for ends that cannot be.
inline void need_ends(planning::NoPath reason) {
  switch (reason) {
    case planning::NoPath::Unreachable:
    case planning::NoPath::LocalMinimum:
    case planning::NoPath::BudgetSpent:
      return;
    default:
      throw std::invalid_argument(planning::to_text(reason));
  }
}

}  // namespace eyebridge::python
