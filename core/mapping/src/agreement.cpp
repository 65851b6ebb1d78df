#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "eyebridge/mapping/ground_truth.hpp"

namespace eyebridge::mapping {
namespace {

/// Where cell (0, 0) of `from` lies among the cells of `to`.
Cell offset_between(const OccupancyGrid& from, const OccupancyGrid& to) {
  constexpr double kTolerance = 1e-6;
  const GridGeometry& a = from.geometry();
  const GridGeometry& b = to.geometry();
  const Vec2 away = (a.origin - b.origin) * (1.0 / b.resolution);
  const Vec2 whole{std::nearbyint(away.x), std::nearbyint(away.y)};
  if (!(std::abs(a.resolution / b.resolution - 1.0) < kTolerance)) {
    throw std::invalid_argument("agreement: the grids have cells of different sizes");
  }
  if (!(norm_squared(away - whole) < kTolerance * kTolerance) || !(norm_squared(whole) < 1e18)) {
    throw std::invalid_argument("agreement: the grids' cells do not lie on each other");
  }
  return {static_cast<int>(whole.x), static_cast<int>(whole.y)};
}

bool occupied_near(const OccupancyGrid& grid, Cell cell, int tolerance) {
  const GridGeometry& g = grid.geometry();
  const int top = std::min(cell.row + tolerance, g.rows - 1);
  const int right = std::min(cell.column + tolerance, g.columns - 1);
  for (int row = std::max(cell.row - tolerance, 0); row <= top; ++row) {
    for (int column = std::max(cell.column - tolerance, 0); column <= right; ++column) {
      if (grid.state(Cell{column, row}) == CellState::Occupied) return true;
    }
  }
  return false;
}

}  // namespace

Agreement agreement(const OccupancyGrid& belief, const OccupancyGrid& truth, int tolerance) {
  constexpr int kMostTolerance = 1000;
  if (tolerance < 0 || tolerance > kMostTolerance) {
    throw std::invalid_argument("agreement: the tolerance is not 0 to 1000 cells");
  }
  const Cell offset = offset_between(belief, truth);
  const GridGeometry& g = belief.geometry();
  Agreement result;
  for (int row = 0; row < g.rows; ++row) {
    for (int column = 0; column < g.columns; ++column) {
      const Cell cell{column, row};
      const Cell there{column + offset.column, row + offset.row};
      const CellState held = belief.state(cell);
      const CellState real = truth.state(there);
      if (held == CellState::Unknown || real == CellState::Unknown) continue;
      ++result.observed;
      const bool agrees =
          held == real || (held == CellState::Occupied ? occupied_near(truth, there, tolerance)
                                                       : occupied_near(belief, cell, tolerance));
      if (agrees) ++result.agreeing;
    }
  }
  return result;
}

double coverage(const OccupancyGrid& belief, const OccupancyGrid& truth, Vec2 start) {
  const Cell offset = offset_between(truth, belief);
  const GridGeometry& g = truth.geometry();
  const Cell first = truth.cell_at(start);
  if (truth.state(first) != CellState::Free) return 0.0;
  std::vector<std::uint8_t> seen(g.size(), 0);
  std::vector<Cell> open{first};
  seen[g.index_of(first)] = 1;
  std::size_t reached = 0;
  std::size_t known = 0;
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    ++reached;
    const Cell there{cell.column + offset.column, cell.row + offset.row};
    if (belief.state(there) != CellState::Unknown) ++known;
    for (const auto& [column, row] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const Cell next{cell.column + column, cell.row + row};
      if (!g.contains(next) || seen[g.index_of(next)] != 0) continue;
      if (truth.state(next) != CellState::Free) continue;
      seen[g.index_of(next)] = 1;
      open.push_back(next);
    }
  }
  return static_cast<double>(known) / static_cast<double>(reached);
}

}  // namespace eyebridge::mapping
