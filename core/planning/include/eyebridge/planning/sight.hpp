#pragma once

#include "eyebridge/planning/path.hpp"
#include "eyebridge/planning/path_progress.hpp"

namespace eyebridge::planning {

// Lines that miss every blocked cell, by walking from cell to cell along them (Amanatides and Woo,
// "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics 1987). A line through the
// corner between two cells passes only if both are free, as A* steps diagonally.

/// Whether the line between the centres of two cells is free. In integers: exact, and the same both
/// ways. `a` and `b` are within the grid.
bool is_free_line(const BlockedRaster& blocked, mapping::Cell a, mapping::Cell b);

/// Whether the line from `a` to `b`, metres, is free; false if either end is outside of the grid or
/// not finite. A cell that the line touches by less than doubles resolve may be missed.
bool is_free_line(const BlockedRaster& blocked, Vec2 a, Vec2 b);

/// The shortest way over some of the way-points of `path`, each in sight of the one before among
/// at most 256 before it; both ends stay. Never longer than `path`, whose own lines are taken as
/// free. `expanded` stays.
Path shortened(const BlockedRaster& blocked, const Path& path);

/// The farthest place ahead on a path, at most `distance` metres, that a robot at `position`,
/// metres, sees, to within a cell; if it sees none, the one `distance` ahead. What lies behind a
/// corner is no goal for DynamicWindow: `blocked` is widened by the robot's radius.
Vec2 farthest_in_sight(const BlockedRaster& blocked, const PathProgress& progress, Vec2 position,
                       double distance);

}  // namespace eyebridge::planning
