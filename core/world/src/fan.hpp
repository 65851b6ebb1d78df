#pragma once

#include <cstdint>
#include <span>

#include "body_map.hpp"
#include "eyebridge/world/world.hpp"
#include "geometry.hpp"
#include "near_walls.hpp"

namespace eyebridge::world {

/// A few rays from one place, in any directions, and how far each of them goes.
///
/// Who meets whom is found in single precision first, many at once and without branches that
/// nobody can foresee; the few pairs of a ray and a wall or disc that are left are worked out
/// exactly. The ranges are those of nearer_hit() and nearer_disc_hit() for all of them.
class Fan {
 public:
  /// So many rays at most.
  static constexpr std::size_t kMost = 16;

  /// No ray has met anything yet. `directions` are lent for as long as the fan is there. No ray
  /// will meet the disc at `self`, BodyMap::place_of() of who looks.
  Fan(Vec2 origin, std::span<const Vec2> directions, double max_range, std::uint32_t self);

  /// Shortens the rays that meet `walls`, by their indices of `segments`. The AVX2 one runs where
  /// RayGrid::has_avx2().
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

  Vec2 origin_;
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
};

}  // namespace eyebridge::world
