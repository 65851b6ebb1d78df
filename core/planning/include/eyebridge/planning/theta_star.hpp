#pragma once

#include "eyebridge/planning/path.hpp"

namespace eyebridge::planning {

/// A way from `start` to `goal`, metres, in straight lines of any angle between centres of cells.
/// Never longer than astar()'s (but for 1e-9 cells for each cell of it), since cells whose distance
/// falls are taken up again; nearly always close to the shortest of any angle, of which no bound is
/// promised. Same calls, same path, on every machine.
///
/// Daniel, Nash, Koenig and Felner, "Theta*: Any-Angle Path Planning on Grids", Journal of
/// Artificial Intelligence Research 39 (2010), the basic variant.
Planned theta_star(const BlockedRaster& blocked, Vec2 start, Vec2 goal);

}  // namespace eyebridge::planning
