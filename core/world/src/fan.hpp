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
  /// will meet the disc at `own_place`, BodyMap::place_of() of who looks.
  Fan(const RayFan& rays, std::uint32_t own_place);

  /// Shortens the rays that meet `walls`, by their indices of `segments`: those that are near the
  /// fan's origin, its spread included.
  void meet_walls(const Segment* segments, const WallList& walls);
  /// Shortens the rays of 1 to kFansTogether fans that meet one of the discs of `map`, of which
  /// none is larger than `largest_radius` metres.
  static void meet_discs(std::span<Fan> fans, const BodyMap& map, double largest_radius);

  [[nodiscard]] std::span<double> ranges() { return {best, directions.size()}; }

  // The rest is for the code of the instruction sets.
  [[nodiscard]] Vec2 origin_of(std::size_t ray) const { return apart ? origins[ray] : origin; }

  Vec2 origin;
  bool apart;          ///< The rays begin at places of their own.
  double spread;       ///< Of the rays' origins around it; 0 where they all begin there.
  std::uint32_t self;  ///< Place in the map of bodies of the one that looks.
  std::span<const Vec2> directions;
  std::span<const Vec2> origins;  ///< Where rays begin at places of their own only.
  /// Along which they look: as many as rays, or half, each ray of the first half looking the other
  /// way of one of the second, in order.
  std::size_t lines;
  alignas(64) double dx[kMost];  ///< Up to a multiple of eight there are rays that meet nothing.
  alignas(64) double dy[kMost];
  alignas(64) double best[kMost];
  float x[kMost];
  float y[kMost];
  // Where rays begin at places of their own only.
  alignas(64) double ox[kMost];
  alignas(64) double oy[kMost];
  /// How far to the right of `origin` the ray's line passes, metres: cross products of where the
  /// ray begins, seen from there, and its direction.
  float beside[kMost];

 private:
  void place();
  /// Whether each ray of the first half begins on the line of one of the second.
  [[nodiscard]] bool have_one_line_each(std::size_t half) const;
};

}  // namespace eyebridge::world
