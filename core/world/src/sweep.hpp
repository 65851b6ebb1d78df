#pragma once

#include <cstdint>
#include <span>

#include "body_map.hpp"
#include "geometry.hpp"
#include "near_walls.hpp"

namespace eyebridge::world {

/// Rays from one place, and how far each of them goes.
///
/// Walls and discs are taken one by one, and meet only the rays that go their way: where few are
/// near, that is much less than what a walk of the rays through a grid costs. The ranges are
/// exactly those of nearer_hit() and nearer_disc_hit() for all of them.
class Sweep {
 public:
  /// So many rays at most.
  static constexpr std::size_t kMost = 512;
  /// So few are tried faster than the right ones among them are found.
  static constexpr std::size_t kFew = 16;

  /// No ray has met anything yet. `gap`: each direction is the one before turned by so many
  /// radians, all of them one turn at most; 0 for any directions, all of which are tried then.
  Sweep(Vec2 origin, std::span<const Vec2> directions, double gap, double max_range);

  /// Shortens the rays that meet `walls`, by their indices of `segments`. The AVX2 one runs where
  /// RayGrid::has_avx2().
  void meet_walls_scalar(const Segment* segments, const WallList& walls);
  void meet_walls_avx2(const Segment* segments, const WallList& walls);
  /// Shortens those that meet one of `discs`, other than that of the body `ignore`.
  void meet_discs_scalar(std::span<const Disc> discs, BodyId ignore);
  void meet_discs_avx2(std::span<const Disc> discs, BodyId ignore);

  /// Same for the discs `begin` to `end` of `rows`, and maybe for some after them: at first only by
  /// floats. For few rays.
  void meet_rows_scalar(const BodyMap::Rows& rows, std::size_t begin, std::size_t end,
                        BodyId ignore);
  void meet_rows_avx2(const BodyMap::Rows& rows, std::size_t begin, std::size_t end, BodyId ignore);

  [[nodiscard]] std::span<double> ranges() { return {best, count_}; }

  // For the code of the instruction sets.
  alignas(64) double dx[kMost];
  alignas(64) double dy[kMost];
  alignas(64) double best[kMost];

 private:
  /// Calls visit(first, last) for runs of rays; all rays that pass between the bearings of `low`
  /// and `high` (counter-clockwise, less than half a turn apart), widened by `wider` radians to
  /// either side, are among them.
  template <class Visit>
  void each_between(double low, double high, double wider, Visit visit) const;
  /// Bearing of `p` from ray 0 in the direction in which the rays are counted; 0 … 2 pi.
  [[nodiscard]] double bearing_of(Vec2 p) const;

  Vec2 origin_;
  std::size_t count_;
  double per_gap_ = 0.0;  ///< Rays a radian; 0: directions are not in order.
  double turn_ = 1.0;     ///< -1 for rays that are counted clockwise.
};

}  // namespace eyebridge::world
