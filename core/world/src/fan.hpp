#pragma once

#include <cstdint>
#include <span>

#include "body_map.hpp"
#include "eyebridge/world/world.hpp"
#include "geometry.hpp"
#include "near_walls.hpp"

namespace eyebridge::world {

/// A few rays from one place, or places near it, in any directions, and how far each of them goes.
///
/// Who meets whom is found in single precision first, many at once and without branches that
/// nobody can foresee; the few pairs of a ray and a wall or disc that are left are worked out
/// exactly. The ranges are those of nearer_hit() and nearer_disc_hit() for all of them.
class Fan {
 public:
  /// So many rays at most.
  static constexpr std::size_t kMost = 16;

  /// Rays that begin farther from the origin than this, metres, are better cast one by one.
  static constexpr double kMostSpread = 1.0;

  /// How far around the origin of `rays` walls are to be looked for, metres: so many different
  /// spreads come to few different reaches, as NearWalls needs them.
  [[nodiscard]] static double reach_of(const RayFan& rays);

  /// No ray has met anything yet. What `rays` lend is lent for as long as the fan is there. No ray
  /// will meet the disc at `self`, BodyMap::place_of() of who looks.
  Fan(const RayFan& rays, std::uint32_t self);

  /// Shortens the rays that meet `walls`, by their indices of `segments`: those that are near the
  /// fan's origin, its spread included. The AVX2 one runs where RayGrid::has_avx2().
  void meet_walls_scalar(const Segment* segments, const WallList& walls);
  void meet_walls_avx2(const Segment* segments, const WallList& walls);
  /// Shortens the rays of 1 to kFansTogether fans that meet one of the discs of `map`, of which
  /// none is larger than `largest_radius` metres.
  static void meet_discs_scalar(std::span<Fan> fans, const BodyMap& map, double largest_radius);
  static void meet_discs_avx2(std::span<Fan> fans, const BodyMap& map, double largest_radius);

  [[nodiscard]] std::span<double> ranges() { return {best_, directions_.size()}; }

 private:
  class Pairs;

  std::uint32_t* look_scalar(const BodyMap::Rows& rows, double off,
                             std::span<const std::uint32_t> starts, std::uint32_t code,
                             std::uint32_t* pairs) const;
  std::uint32_t* look_avx2(const BodyMap::Rows& rows, double off,
                           std::span<const std::uint32_t> starts, std::uint32_t code,
                           std::uint32_t* pairs) const;
  template <class Meets>
  [[nodiscard]] std::uint64_t word_scalar(std::size_t octet, Meets meets) const;
  template <class Meets>
  [[nodiscard]] std::uint64_t word_avx2(std::size_t octet, Meets meets) const;
  void meet_scalar(const Segment* segments, const std::uint32_t* indices, Pairs& pairs);
  void meet_avx2(const Segment* segments, const std::uint32_t* indices, Pairs& pairs);
  void meet_scalar(const Disc& disc);
  void meet_avx2(const Disc& disc);
  void meet_apart_scalar(const Disc& disc);
  void meet_apart_avx2(const Disc& disc);

  void place(std::span<const Vec2> origins);
  /// Whether each ray of the first half begins on the line of one of the second.
  [[nodiscard]] bool have_one_line_each(std::size_t half) const;
  [[nodiscard]] Vec2 origin_of(std::size_t ray) const {
    return apart_ ? Vec2{ox_[ray], oy_[ray]} : origin_;
  }

  Vec2 origin_;
  bool apart_;          ///< The rays begin at places of their own.
  double spread_;       ///< Of the rays' origins around it; 0 where they all begin there.
  std::uint32_t self_;  ///< Who looks: its place in the map of bodies.
  std::span<const Vec2> directions_;
  /// Along which they look: as many as rays, or half, each ray of the first half looking the other
  /// way of one of the second, in order.
  std::size_t lines_;
  alignas(64) double dx_[kMost];  ///< Up to a multiple of eight there are rays that meet nothing.
  alignas(64) double dy_[kMost];
  alignas(64) double best_[kMost];
  float x_[kMost];
  float y_[kMost];
  // Where rays begin at places of their own only.
  alignas(64) double ox_[kMost];
  alignas(64) double oy_[kMost];
  /// How far to the right of `origin_` the ray's line passes, metres: cross products of where the
  /// ray begins, seen from there, and its direction.
  float beside_[kMost];
};

}  // namespace eyebridge::world
