#include "eyebridge/planning/frontiers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "eyebridge/planning/clearance.hpp"
#include "eyebridge/planning/wavefront.hpp"

namespace eyebridge::planning {
namespace {

using mapping::Cell;
using mapping::CellState;

bool is_frontier(const KnowledgeRaster& known, Cell cell) {
  if (known[cell] != CellState::Free) return false;
  const auto unknown = [&](int right, int up) {
    const Cell beside{cell.column + right, cell.row + up};
    return known.geometry.contains(beside) && known[beside] == CellState::Unknown;
  };
  return unknown(1, 0) || unknown(0, 1) || unknown(-1, 0) || unknown(0, -1);
}

/// All that hangs together with `seed`; taken out of `open`.
Frontier take_piece(mapping::Raster<std::uint8_t>& open, Cell seed) {
  Frontier piece;
  open[seed] = 0;
  piece.cells.push_back(seed);
  for (std::size_t next = 0; next < piece.cells.size(); ++next) {
    const Cell cell = piece.cells[next];
    for (int up = -1; up <= 1; ++up) {
      for (int right = -1; right <= 1; ++right) {
        const Cell beside{cell.column + right, cell.row + up};
        if (!open.geometry.contains(beside) || open[beside] == 0) continue;
        open[beside] = 0;
        piece.cells.push_back(beside);
      }
    }
  }
  std::sort(piece.cells.begin(), piece.cells.end(),
            [&](Cell a, Cell b) { return open.geometry.index_of(a) < open.geometry.index_of(b); });
  Vec2 sum;
  for (const Cell cell : piece.cells) sum = sum + open.geometry.centre_of(cell);
  piece.centroid = 1.0 / static_cast<double>(piece.cells.size()) * sum;
  return piece;
}

/// Where a robot of `radius` must not be: too near what is occupied, or in the unknown.
BlockedRaster blocked_for(const KnowledgeRaster& known, double radius) {
  BlockedRaster occupied(known.geometry);
  for (std::size_t i = 0; i < known.cells.size(); ++i) {
    occupied.cells[i] = known.cells[i] == CellState::Occupied ? 1 : 0;
  }
  BlockedRaster blocked = widened(clearance_of(occupied), radius);
  for (std::size_t i = 0; i < known.cells.size(); ++i) {
    if (known.cells[i] == CellState::Unknown) blocked.cells[i] = 1;
  }
  return blocked;
}

}  // namespace

std::vector<Frontier> frontiers_of(const KnowledgeRaster& known, std::size_t smallest) {
  const mapping::GridGeometry& grid = known.geometry;
  mapping::Raster<std::uint8_t> open(grid);
  const auto each_cell = [&](const auto& visit) {
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) visit(Cell{column, row});
    }
  };
  each_cell([&](Cell cell) { open[cell] = is_frontier(known, cell) ? 1 : 0; });
  std::vector<Frontier> frontiers;
  each_cell([&](Cell cell) {
    if (open[cell] == 0) return;
    Frontier piece = take_piece(open, cell);
    if (piece.cells.size() >= smallest) frontiers.push_back(std::move(piece));
  });
  return frontiers;
}

tl::expected<Exploration, NoPath> nearest_frontier(const KnowledgeRaster& known, Vec2 position,
                                                   const ExplorationSettings& settings) {
  const BlockedRaster blocked = blocked_for(known, settings.radius);
  const tl::expected<Ends, NoPath> ends = ends_of(blocked, position, position);
  if (!ends) return tl::unexpected(ends.error());
  const DistanceField field = wavefront(blocked, {&position, 1});
  std::vector<Frontier> frontiers = frontiers_of(known, settings.smallest);
  double shortest = std::numeric_limits<double>::infinity();
  Cell target;
  Frontier* nearest = nullptr;
  for (Frontier& frontier : frontiers) {
    for (const Cell cell : frontier.cells) {
      if (field[cell] >= shortest) continue;
      shortest = field[cell];
      target = cell;
      nearest = &frontier;
    }
  }
  if (nearest == nullptr) return tl::unexpected(NoPath::Unreachable);
  Planned path = path_down(blocked, field, known.geometry.centre_of(target));
  if (!path) return tl::unexpected(path.error());
  std::reverse(path->points.begin(), path->points.end());
  return Exploration{std::move(*nearest), std::move(*path)};
}

}  // namespace eyebridge::planning
