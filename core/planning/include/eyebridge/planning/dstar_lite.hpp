#pragma once

#include <memory>

#include "eyebridge/planning/path.hpp"

namespace eyebridge::planning {

/// Shortest ways to one goal from a robot that moves, over a grid that changes as it is explored:
/// what an earlier plan found out is kept, and only what the changes touch is searched again.
///
/// Koenig and Likhachev, "D* Lite", AAAI (2002), the optimised version. Paths are exactly as long
/// as astar()'s, over the same steps. Not thread-safe; needs 22 bytes a cell, and
/// 24 more for each that a search has open.
class DStarLite {
 public:
  /// A plan to `goal`, metres, over a copy of `blocked`. Plans say it if the goal is outside.
  DStarLite(const BlockedRaster& blocked, Vec2 goal);
  DStarLite(DStarLite&&) noexcept;
  DStarLite& operator=(DStarLite&&) noexcept;
  ~DStarLite();

  /// Notes a change of `cell`, which is within the grid; the same as before costs nothing.
  void set_blocked(mapping::Cell cell, bool blocked);

  /// The grid as it is now.
  [[nodiscard]] const BlockedRaster& blocked() const;

  /// The shortest way from `start`, metres. `expanded` counts this call's work only.
  Planned plan(Vec2 start);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace eyebridge::planning
