#pragma once

#include <cstddef>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::mapping {

/// How a world becomes a grid.
struct TruthSettings {
  double resolution = 0.05;  ///< Metres, > 0.
  int margin = 1;            ///< Cells around the floor, >= 0: walls on its edge need one.
  bool objects = false;      ///< Whether things but balls count, where they stand at first.
  std::size_t max_cells = kMostMapCells;
};

/// What really stands on the floor of `model`: cells that hold a part of a wall (or object) are
/// occupied, all others free.
///
/// A cell has its lower and left edge, not its upper and right one, so that a bare wall along a
/// line between cells lies in one row of them. Throws std::invalid_argument for settings that
/// cannot be and for a world that needs more than `max_cells`.
OccupancyGrid truth_of(const world::WorldModel& model, const TruthSettings& settings = {});

/// How much of a belief is right.
struct Agreement {
  std::size_t observed =
      0;  ///< Cells that the belief holds for free or occupied, and the truth knows.
  std::size_t agreeing = 0;  ///< Of them, those that agree.

  /// 0 … 1; 1 when nothing was observed.
  [[nodiscard]] double share() const {
    return observed == 0 ? 1.0 : static_cast<double>(agreeing) / static_cast<double>(observed);
  }
};

/// Compares what `belief` holds for free or occupied with `truth`, cell by cell.
///
/// A wall is thinner than a cell and may lie on the border of two, so that it, or its half, may be
/// found in the cell beside the one that it was drawn in. With `tolerance` t, an occupied cell
/// agrees when the truth has an occupied one at most t columns and t rows away; a free cell that is
/// occupied in truth agrees when the belief has an occupied one as near. 0 compares each cell with
/// itself only. Throws std::invalid_argument when the grids' resolutions differ, when their origins
/// do not differ by a whole number of cells (both to 1e-6 of a cell), and for a tolerance that is
/// not 0 … 1000.
Agreement agreement(const OccupancyGrid& belief, const OccupancyGrid& truth, int tolerance = 1);

/// Share, 0 … 1, of the cells of `truth` that a robot at `start` can reach, in steps to the four
/// neighbours through free cells, whose state in `belief` is known. 0 when `start` is not free.
/// Throws as agreement() does.
double coverage(const OccupancyGrid& belief, const OccupancyGrid& truth, Vec2 start);

}  // namespace eyebridge::mapping
