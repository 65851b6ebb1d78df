#pragma once

#include <span>

#include "eyebridge/planning/path.hpp"

namespace eyebridge::planning {

/// Which cells a step may go to.
enum class Neighbours {
  Four,   ///< Right, up, left, down.
  Eight,  ///< Diagonally as well, where both cells beside the step are free.
};

/// Length of the shortest way to a goal, metres, by cell.
using DistanceField = mapping::Raster<double>;

/// Distance of every cell to the nearest of `goals` (metres), over the centres of cells: a wave
/// that floods the grid from the goals. Infinite in blocked cells and where no way leads; goals
/// that are blocked, outside or not finite start no wave.
///
/// Flood fill as in Barraquand, Langlois and Latombe, "Numerical potential field techniques for
/// robot path planning", IEEE Trans. SMC 22 (1992); with eight neighbours Dijkstra's algorithm
/// (Numerische Mathematik 1, 1959) over buckets.
DistanceField wavefront(const BlockedRaster& blocked, std::span<const Vec2> goals,
                        Neighbours neighbours = Neighbours::Eight);

/// The way from `start`, metres, down a field that wavefront() made of the same grid with the same
/// neighbours: a shortest one. It ends in the centre of a goal's cell; `expanded` counts its cells.
Planned path_down(const BlockedRaster& blocked, const DistanceField& field, Vec2 start,
                  Neighbours neighbours = Neighbours::Eight);

}  // namespace eyebridge::planning
