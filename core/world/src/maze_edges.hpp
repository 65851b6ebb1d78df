#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::world {

/// Rays through a maze, cell by cell: each border is one bit, no wall is ever intersected.
class MazeEdges {
 public:
  explicit MazeEdges(const MazeGrid& maze);

  /// True when every wall of `model` is an edge of its maze and nothing else, so that this may
  /// answer for the world.
  static bool describes(const WorldModel& model);

  /// True when a point lies on one of the lines that the walls stand on: then rays along walls and
  /// rays that start on them need the exact geometry, and cast() may not be asked.
  [[nodiscard]] bool on_line(Vec2 point) const;

  /// Ranges along `directions` from `origin`; `max_range` where nothing is nearer.
  void cast(Vec2 origin, std::span<const Vec2> directions, double max_range,
            std::span<double> ranges) const;

 private:
  enum Side : std::uint8_t { kEast = 1, kNorth = 2, kWest = 4, kSouth = 8 };

  double cell_;
  std::size_t columns_;              ///< Of the maze, with a ring of cells around it.
  std::size_t rows_;                 ///< Same.
  std::vector<std::uint8_t> sides_;  ///< Which sides of a cell have a wall.
};

}  // namespace eyebridge::world
