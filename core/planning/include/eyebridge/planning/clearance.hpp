#pragma once

#include "eyebridge/planning/path.hpp"

namespace eyebridge::planning {

/// Distance to the nearest obstacle, metres.
using ClearanceRaster = mapping::Raster<float>;

/// Distance from the centre of each cell to the nearest point of a blocked cell, metres: 0 in
/// blocked cells, half a cell beside them, infinite where nothing is blocked. The edge of the grid
/// is no obstacle. Exact but for the rounding to float; time grows with the number of cells only.
///
/// Felzenszwalb and Huttenlocher, "Distance Transforms of Sampled Functions", Theory of Computing
/// 8 (2012), in integers, on a lattice of half cells so that cells are squares and not points.
ClearanceRaster clearance_of(const BlockedRaster& blocked);

/// Cells in whose centre a round robot of `radius` metres, >= 0, would overlap a blocked one, and
/// the blocked ones themselves. Between the centres of two such free cells that touch, it may come
/// up to 0.71 cells nearer: add that to the radius if no touch is allowed.
BlockedRaster widened(const ClearanceRaster& clearance, double radius);

/// A lower bound of the distance from `point` to the nearest point of a blocked cell, metres, and
/// less than 1.42 cells below it; 0 outside of the grid.
double clearance_at(const ClearanceRaster& clearance, Vec2 point);

}  // namespace eyebridge::planning
