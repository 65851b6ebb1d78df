#pragma once

#include <cstddef>
#include <vector>

#include <tl/expected.hpp>

#include "eyebridge/mapping/occupancy_grid.hpp"
#include "eyebridge/planning/path.hpp"

namespace eyebridge::planning {

/// What is known of each cell.
using KnowledgeRaster = mapping::Raster<mapping::CellState>;

/// Free cells at the edge of what is known, in one piece.
struct Frontier {
  std::vector<mapping::Cell> cells;  ///< Row by row from below.
  Vec2 centroid;  ///< Mean of their centres, metres; need not lie in one of them.
};

/// The frontiers of `known` with at least `smallest` cells, in the order of their first cells. A
/// cell belongs to one if it is free and shares an edge with an unknown cell; cells that share a
/// corner are one piece. Beyond the edge of the grid nothing is unknown.
///
/// Yamauchi, "A Frontier-Based Approach for Autonomous Exploration", IEEE CIRA (1997).
std::vector<Frontier> frontiers_of(const KnowledgeRaster& known, std::size_t smallest = 1);

/// Where to explore next.
struct Exploration {
  Frontier frontier;
  Path path;  ///< From the robot's cell to the frontier's cell nearest to it, by way.
};

struct ExplorationSettings {
  double radius = 0.0;       ///< Of the robot: so far it stays from occupied cells, metres, >= 0.
  std::size_t smallest = 1;  ///< Frontiers of fewer cells are left alone.
};

/// The frontier that a robot at `position`, metres, reaches first, over free cells only; with a
/// radius, over those alone where it touches nothing occupied, so that some may stay out of reach.
/// Unreachable: there is none left, and it is done. StartBlocked: it stands in no free cell, or
/// too near an occupied one.
tl::expected<Exploration, NoPath> nearest_frontier(const KnowledgeRaster& known, Vec2 position,
                                                   const ExplorationSettings& settings = {});

}  // namespace eyebridge::planning
