#pragma once

#include "eyebridge/planning/path.hpp"

namespace eyebridge::planning {

/// The shortest way from `start` to `goal`, metres, over the centres of cells with eight
/// neighbours; a diagonal step needs both cells beside it free. Way-points are where it turns, from
/// the centre of the start's cell to that of the goal's. Same calls, same path, on every machine.
///
/// Hart, Nilsson and Raphael, "A Formal Basis for the Heuristic Determination of Minimum Cost
/// Paths", IEEE Trans. SSC 4 (1968), with the octile distance as heuristic.
Planned astar(const BlockedRaster& blocked, Vec2 start, Vec2 goal);

}  // namespace eyebridge::planning
