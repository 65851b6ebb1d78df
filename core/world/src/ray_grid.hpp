#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry.hpp"
#include "ray_query.hpp"
#include "segment_grid.hpp"

namespace eyebridge::world {

/// A uniform grid of walls; rays walk the cells in their way, neighbours side by side.
///
/// Ranges are exactly those of a loop over all walls with nearer_hit(), whichever instruction set
/// was used: a ray is tried against too many walls at most.
class RayGrid {
 public:
  explicit RayGrid(const std::vector<Segment>& segments);

  /// Ranges along `directions` from `origin`; `max_range` where nothing is nearer.
  void cast_scalar(Vec2 origin, std::span<const Vec2> directions, double max_range,
                   std::span<double> ranges) const;
  /// Same on CPUs with AVX2 (see has_avx2()).
  void cast_avx2(Vec2 origin, std::span<const Vec2> directions, double max_range,
                 std::span<double> ranges) const;

  static bool has_avx2();

  /// Rays that walk together.
  static constexpr std::size_t kChunk = 128;

 private:
  /// Rays farther apart than this are not tried together, even in one cell.
  static constexpr std::size_t kMaxGap = 8;

  /// Fills one of `states` for each of `directions`, and `active` with the indices of the rays that
  /// meet the grid, ascending; returns how many.
  std::size_t start_rays(Vec2 origin, std::span<const Vec2> directions, double max_range,
                         RayState* states, std::uint32_t* active) const;

  SegmentGrid grid_;
  std::vector<std::uint32_t> starts_;  ///< Cell -> first of its segments; one more at the end.
  std::vector<Segment> segments_;      ///< Those of each cell together.
};

}  // namespace eyebridge::world
