#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "eyebridge/base/random.hpp"
#include "eyebridge/planning/path.hpp"

namespace eyebridge::planning::test {

using mapping::Cell;

/// A grid with '#' where blocked, the upper row first, as one reads it.
inline BlockedRaster drawn(const std::vector<std::string_view>& rows, double resolution = 1.0,
                           Vec2 origin = {}) {
  BlockedRaster blocked(
      {origin, resolution, static_cast<int>(rows.front().size()), static_cast<int>(rows.size())});
  for (int row = 0; row < blocked.geometry.rows; ++row) {
    for (int column = 0; column < blocked.geometry.columns; ++column) {
      const std::string_view line = rows[rows.size() - 1 - static_cast<std::size_t>(row)];
      blocked[{column, row}] = line[static_cast<std::size_t>(column)] == '#' ? 1 : 0;
    }
  }
  return blocked;
}

/// A cell of a grid, drawn evenly.
inline Cell random_cell(const mapping::GridGeometry& geometry, Random& random) {
  return {static_cast<int>(random.uniform() * geometry.columns),
          static_cast<int>(random.uniform() * geometry.rows)};
}

/// Each cell blocked with probability `density`.
inline BlockedRaster random_grid(int columns, int rows, double density, Random& random,
                                 double resolution = 1.0) {
  BlockedRaster blocked({{-1.5, 2.5}, resolution, columns, rows});
  for (std::uint8_t& cell : blocked.cells) cell = random.chance(density) ? 1 : 0;
  return blocked;
}

/// Whether a robot may step from one cell to a neighbour, said in the plainest way.
inline bool may_step(const BlockedRaster& blocked, Cell from, int right, int up) {
  const auto free = [&](Cell cell) {
    return blocked.geometry.contains(cell) && blocked[cell] == 0;
  };
  return free(from) && free({from.column + right, from.row + up}) &&
         free({from.column + right, from.row}) && free({from.column, from.row + up});
}

/// Brute force (Bellman and Ford): distance of each cell to the nearest of `goals`, in cells, by
/// going over the whole grid until nothing changes. Infinite where no way leads.
inline std::vector<double> brute_force(const BlockedRaster& blocked, const std::vector<Cell>& goals,
                                       bool diagonally = true) {
  const mapping::GridGeometry& grid = blocked.geometry;
  std::vector<double> distances(grid.size(), std::numeric_limits<double>::infinity());
  for (const Cell goal : goals) {
    if (blocked[goal] == 0) distances[grid.index_of(goal)] = 0.0;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        double& own = distances[grid.index_of({column, row})];
        for (int up = -1; up <= 1; ++up) {
          for (int right = -1; right <= 1; ++right) {
            const bool diagonal = right != 0 && up != 0;
            if ((right == 0 && up == 0) || (diagonal && !diagonally)) continue;
            if (!may_step(blocked, {column, row}, right, up)) continue;
            const double way = distances[grid.index_of({column + right, row + up})] +
                               (diagonal ? std::sqrt(2.0) : 1.0);
            if (way >= own - 1e-9) continue;
            own = way;
            changed = true;
          }
        }
      }
    }
  }
  return distances;
}

/// Distance from `point` to the nearest blocked cell, over all of them that are at most `cells`
/// away, from the definition; infinite if there is none.
inline double nearest_square(const BlockedRaster& blocked, Vec2 point, int cells = 1000) {
  const mapping::GridGeometry& grid = blocked.geometry;
  const Cell own = grid.cell_at(point);
  double nearest = std::numeric_limits<double>::infinity();
  for (int row = std::max(0, own.row - cells); row < grid.rows && row <= own.row + cells; ++row) {
    for (int column = std::max(0, own.column - cells);
         column < grid.columns && column <= own.column + cells; ++column) {
      if (blocked[{column, row}] == 0) continue;
      const Vec2 away = grid.centre_of({column, row}) - point;
      const double half = 0.5 * grid.resolution;
      const Vec2 gap{std::max(std::abs(away.x) - half, 0.0),
                     std::max(std::abs(away.y) - half, 0.0)};
      nearest = std::min(nearest, norm(gap));
    }
  }
  return nearest;
}

/// Whether a line misses all blocked cells, looked at every thousandth of a cell: no shared code
/// with the planners'.
inline bool is_clear(const BlockedRaster& blocked, Vec2 a, Vec2 b) {
  const mapping::GridGeometry& grid = blocked.geometry;
  const int steps = static_cast<int>(norm(b - a) / grid.resolution * 1000) + 1;
  for (int i = 0; i <= steps; ++i) {
    const Cell cell = grid.cell_at(a + static_cast<double>(i) / steps * (b - a));
    if (!grid.contains(cell) || blocked[cell] != 0) return false;
  }
  return true;
}

inline bool is_clear(const BlockedRaster& blocked, const std::vector<Vec2>& points) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!is_clear(blocked, points[i - 1], points[i])) return false;
  }
  return true;
}

}  // namespace eyebridge::planning::test
