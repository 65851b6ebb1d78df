#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry.hpp"
#include "ray_query.hpp"
#include "segment_grid.hpp"

namespace eyebridge::world {

/// A uniform grid of walls; rays walk the cells in their way, neighbours side by side, and leap
/// over empty floor.
///
/// Ranges are exactly those of a loop over all walls with nearer_hit(): a ray is tried against too
/// many walls at most.
class RayGrid {
 public:
  explicit RayGrid(const std::vector<Segment>& segments);

  /// Ranges along `directions` from `origin`; `max_range` where nothing is nearer.
  void cast(Vec2 origin, std::span<const Vec2> directions, double max_range,
            std::span<double> ranges) const;

 private:
  /// Sets `group` to those of `directions` that meet the grid.
  void start_rays(Vec2 origin, std::span<const Vec2> directions, double max_range,
                  RayGroup& group) const;
  /// Lets the rays of `group` go until each has met something or has left the grid.
  void walk(Vec2 origin, RayGroup& group) const;

  SegmentGrid grid_;
  std::vector<std::uint32_t> starts_;  ///< Cell -> first of its segments; one more at the end.
  std::vector<Segment> segments_;      ///< Those of each cell together.
  /// Cell -> how far the cells around it are empty; none where there is too little empty floor.
  std::vector<std::uint8_t> clear_;
};

}  // namespace eyebridge::world
