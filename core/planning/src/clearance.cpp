#include "eyebridge/planning/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "eyebridge/mapping/envelope.hpp"

namespace eyebridge::planning {
namespace {

using mapping::Envelope;
using Half = Envelope::Number;  // lengths in halves of a cell, and their squares
constexpr Half kNothing = std::numeric_limits<Half>::max();

/// Squared distance of each cell's centre to the nearest blocked square of its own column.
std::vector<Half> along_columns(const BlockedRaster& blocked) {
  const std::size_t columns = static_cast<std::size_t>(blocked.geometry.columns);
  const std::size_t size = blocked.cells.size();
  std::vector<Half> squared(size, kNothing);
  std::vector<Half> since(columns, kNothing);
  const auto sweep = [&](std::size_t row) {
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t at = row + i;
      if (blocked.cells[at] != 0) {
        since[i] = 0;
      } else if (since[i] != kNothing) {
        since[i] += since[i] == 0 ? 1 : 2;  // from the edge of the blocked cell
      }
      if (since[i] != kNothing) squared[at] = std::min(squared[at], since[i] * since[i]);
    }
  };
  for (std::size_t row = 0; row < size; row += columns) sweep(row);
  std::fill(since.begin(), since.end(), kNothing);
  for (std::size_t row = size; row > 0; row -= columns) sweep(row - columns);
  return squared;
}

}  // namespace

ClearanceRaster clearance_of(const BlockedRaster& blocked) {
  ClearanceRaster clearance(blocked.geometry, std::numeric_limits<float>::infinity());
  const std::size_t columns = static_cast<std::size_t>(blocked.geometry.columns);
  const std::vector<Half> squared = along_columns(blocked);
  const double half_cell = 0.5 * blocked.geometry.resolution;
  Envelope envelope(2 * columns + 1);
  for (std::size_t row = 0; row < squared.size(); row += columns) {
    envelope.clear();
    // Cell i reaches from 2 i to 2 i + 2. Its nearest point to a centre is its own centre line for
    // cells of the same column, else its edge; an edge belongs to the lower of its two cells.
    Half before = kNothing;
    for (std::size_t i = 0; i < columns; ++i) {
      const Half site = 2 * static_cast<Half>(i);
      const Half own = squared[row + i];
      if (const Half edge = std::min(before, own); edge != kNothing) envelope.add(site, edge);
      if (own != kNothing) envelope.add(site + 1, own);
      before = own;
    }
    const Half end = 2 * static_cast<Half>(columns);
    if (before != kNothing) envelope.add(end, before);
    envelope.each(1, 2, end, [&](Half x, Half lowest) {
      clearance.cells[row + static_cast<std::size_t>(x / 2)] =
          static_cast<float>(half_cell * std::sqrt(static_cast<double>(lowest)));
    });
  }
  return clearance;
}

BlockedRaster widened(const ClearanceRaster& clearance, double radius) {
  BlockedRaster blocked(clearance.geometry);
  for (std::size_t i = 0; i < blocked.cells.size(); ++i) {
    const double room = static_cast<double>(clearance.cells[i]);
    blocked.cells[i] = room < radius || room == 0.0 ? 1 : 0;
  }
  return blocked;
}

double clearance_at(const ClearanceRaster& clearance, Vec2 point) {
  const mapping::GridGeometry& grid = clearance.geometry;
  if (!is_within(grid, point)) return 0.0;
  // No obstacle is nearer than a centre's clearance less the way there: the best of the four
  // centres around, of which one lies away from the nearest obstacle.
  const double half = 0.5 * grid.resolution;
  const mapping::Cell low = grid.cell_at(point - Vec2{half, half});
  double room = 0.0;
  for (int up = 0; up < 2; ++up) {
    for (int right = 0; right < 2; ++right) {
      const mapping::Cell cell{low.column + right, low.row + up};
      if (!grid.contains(cell)) continue;
      const double off = norm(point - grid.centre_of(cell));
      room = std::max(room, static_cast<double>(clearance[cell]) - off);
    }
  }
  return room;
}

}  // namespace eyebridge::planning
