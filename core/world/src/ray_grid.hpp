#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry.hpp"
#include "segment_grid.hpp"

namespace eyebridge::world {

/// Up to eight segments of one cell, in single precision and relative to the grid's origin: a quick
/// look at which of them a ray may hit. Unused lanes are NaN, which no ray hits.
struct alignas(32) RayBlock {
  static constexpr std::size_t kLanes = 8;

  float ax[kLanes];
  float ay[kLanes];
  float ux[kLanes];
  float uy[kLanes];
  float length[kLanes];
  std::uint32_t segment[kLanes];  ///< Index of the lane's segment.
};

/// A uniform grid whose cells hold RayBlocks; a ray walks the cells in its way.
///
/// Single precision only sorts out, with a margin that is wider than its rounding; what it lets
/// through is intersected in double. So ranges are exactly those of a loop over all segments,
/// whichever instruction set was used.
class RayGrid {
 public:
  /// `segments` must live as long as the grid.
  explicit RayGrid(const std::vector<Segment>& segments);

  /// Ranges along `directions` from `origin`; `max_range` where nothing is nearer.
  void cast_scalar(Vec2 origin, std::span<const Vec2> directions, double max_range,
                   std::span<double> ranges) const;
  /// Same on CPUs with AVX2 (see has_avx2()).
  void cast_avx2(Vec2 origin, std::span<const Vec2> directions, double max_range,
                 std::span<double> ranges) const;

  static bool has_avx2();

 private:
  struct Cell {
    std::uint32_t first = 0;  ///< Into blocks_.
    std::uint32_t count = 1;  ///< At least 1: block 0 is empty and shared by all empty cells.
  };

  const std::vector<Segment>& segments_;
  SegmentGrid grid_;
  std::vector<Cell> cells_;
  std::vector<RayBlock> blocks_;
  double size_ = 1.0;    ///< Diagonal of the grid, metres.
  float margin_ = 0.0F;  ///< Bound on the rounding errors of a quick look, metres.
};

}  // namespace eyebridge::world
