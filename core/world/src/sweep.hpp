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

  /// No ray has met anything yet. `gap`: each direction is the one before turned by so many
  /// radians, not 0, all of them one turn at most.
  Sweep(Vec2 from, std::span<const Vec2> directions, double gap, double max_range);

  /// Shortens the rays that meet `walls`, by their indices of `segments`.
  void meet_walls(const Segment* segments, const WallList& walls);
  /// Shortens those that meet one of `discs`, other than that of the body `ignore`.
  void meet_discs(std::span<const Disc> discs, BodyId ignore);
  /// Shortens those that meet one of the discs of `map`, of which none is larger than
  /// `largest_radius` metres. The one that looks is hidden there.
  void meet_discs(const BodyMap& map, double largest_radius);

  [[nodiscard]] std::span<double> ranges() { return {best, count}; }

  // The rest is for the code of the instruction sets.
  /// Calls visit(first, last) for runs of rays; all between the numbers `from` and `to`, modulo a
  /// turn, are among them. `from` is less than a turn, `to` not less than 0.
  template <class Visit>
  void each_between(double from, double to, Visit visit) const;
  /// The number of the ray that points to `p`, which need not be whole: 0 to less than a turn.
  [[nodiscard]] double number_of(Vec2 p) const;

  /// A ray's horizon is that of this many neighbours, itself the first.
  static constexpr std::size_t kWindow = 5;
  /// Registers reach this far beyond the last ray.
  static constexpr std::size_t kBeyond = 8;
  alignas(64) double dx[kMost + kBeyond];
  alignas(64) double dy[kMost + kBeyond];
  alignas(64) double best[kMost + kBeyond];
  Vec2 origin;
  std::size_t count;
  double per_gap;  ///< Rays a radian.
  double period;   ///< Rays a turn.
  double turn;     ///< -1 for rays that are counted clockwise.
};

}  // namespace eyebridge::world
