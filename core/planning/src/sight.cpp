#include "eyebridge/planning/sight.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace eyebridge::planning {
namespace {

using mapping::Cell;

constexpr std::size_t kLookBack = 256;

/// Where along a line (0 at its start, 1 at its end) it leaves its cells along one axis.
struct Crossings {
  double next = std::numeric_limits<double>::infinity();
  double apart = 0.0;
  int direction = 1;
  int left = 0;  ///< How many are still to come.

  Crossings(double from, double to, int from_cell, int to_cell, double origin, double resolution) {
    left = std::abs(to_cell - from_cell);
    if (left == 0) return;
    direction = to_cell > from_cell ? 1 : -1;
    const double border = origin + (from_cell + (direction > 0 ? 1 : 0)) * resolution;
    next = (border - from) / (to - from);
    apart = resolution / std::abs(to - from);
  }
  void pass() {
    --left;
    next = left == 0 ? std::numeric_limits<double>::infinity() : next + apart;
  }
};

}  // namespace

bool is_free_line(const BlockedRaster& blocked, Cell a, Cell b) {
  const int columns = std::abs(b.column - a.column);
  const int rows = std::abs(b.row - a.row);
  const int right = b.column > a.column ? 1 : -1;
  const int up = b.row > a.row ? 1 : -1;
  // Twice the line's offset from the corner ahead, times its length: which border comes first.
  std::int64_t lead = columns - rows;
  if (blocked[a] != 0) return false;
  for (Cell at = a; at != b;) {
    if (lead == 0) {
      if (blocked[{at.column + right, at.row}] != 0) return false;
      if (blocked[{at.column, at.row + up}] != 0) return false;
      at = {at.column + right, at.row + up};
      lead += 2 * (std::int64_t{columns} - rows);
    } else if (lead > 0) {
      at.column += right;
      lead -= 2 * std::int64_t{rows};
    } else {
      at.row += up;
      lead += 2 * std::int64_t{columns};
    }
    if (blocked[at] != 0) return false;
  }
  return true;
}

bool is_free_line(const BlockedRaster& blocked, Vec2 a, Vec2 b) {
  const mapping::GridGeometry& grid = blocked.geometry;
  if (!is_within(grid, a) || !is_within(grid, b)) return false;
  Cell at = grid.cell_at(a);
  const Cell end = grid.cell_at(b);
  Crossings x(a.x, b.x, at.column, end.column, grid.origin.x, grid.resolution);
  Crossings y(a.y, b.y, at.row, end.row, grid.origin.y, grid.resolution);
  if (blocked[at] != 0) return false;
  while (x.left > 0 || y.left > 0) {
    const bool corner = x.next == y.next;
    if (corner) {
      if (blocked[{at.column + x.direction, at.row}] != 0) return false;
      if (blocked[{at.column, at.row + y.direction}] != 0) return false;
    }
    const bool sideways = x.next <= y.next;
    const bool upwards = y.next <= x.next;
    if (sideways) {
      at.column += x.direction;
      x.pass();
    }
    if (upwards) {
      at.row += y.direction;
      y.pass();
    }
    if (blocked[at] != 0) return false;
  }
  return true;
}

Vec2 farthest_in_sight(const BlockedRaster& blocked, const PathProgress& progress, Vec2 position,
                       double distance) {
  for (double ahead = std::min(distance, progress.remaining()); ahead > 0.0;
       ahead -= blocked.geometry.resolution) {
    const Vec2 place = progress.ahead(ahead);
    if (is_free_line(blocked, position, place)) return place;
  }
  return progress.ahead(distance);
}

Path shortened(const BlockedRaster& blocked, const Path& path) {
  const std::vector<Vec2>& points = path.points;
  if (points.size() < 3) return path;
  std::vector<double> shortest(points.size(), 0.0);
  std::vector<std::size_t> from(points.size(), 0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    from[i] = i - 1;
    shortest[i] = shortest[i - 1] + norm(points[i] - points[i - 1]);
    for (std::size_t j = i > kLookBack ? i - kLookBack : 0; j + 1 < i; ++j) {
      const double length = shortest[j] + norm(points[i] - points[j]);
      if (length >= shortest[i] || !is_free_line(blocked, points[j], points[i])) continue;
      shortest[i] = length;
      from[i] = j;
    }
  }
  Path result;
  result.expanded = path.expanded;
  for (std::size_t i = points.size() - 1; i != 0; i = from[i]) result.points.push_back(points[i]);
  result.points.push_back(points.front());
  std::reverse(result.points.begin(), result.points.end());
  result.length = length_of(result.points);
  return result;
}

}  // namespace eyebridge::planning
