#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::world {

/// A straight piece of a wall's outline: points a + s * u for s in 0 … length.
struct Segment {
  Vec2 a;
  Vec2 u;               ///< Unit vector from `a` to the other end.
  double length = 0.0;  ///< Metres, > 0.
};

/// Segment from `a` to `b`, which differ.
Segment segment_between(Vec2 a, Vec2 b);

/// What discs and rays meet of `walls`: a bare line is one segment, a thick wall the four edges of
/// its rectangle. Heights play no part.
std::vector<Segment> outlines_of(const std::vector<Wall>& walls);

/// Rays: a hit this near behind the origin, or this far beyond a wall's end, counts. It closes the
/// joint of two walls against rounding, metres.
inline constexpr double kRayTolerance = 1e-9;

/// Below this sine of the angle between them ray and wall are parallel: over 1 km the ray drifts by
/// less than kRayTolerance.
inline constexpr double kParallel = 1e-12;

/// Range along the ray (`direction` is a unit vector) to `wall` where that is less than `best`,
/// else `best`. A ray along the wall's own line meets its nearer end; one from a point on the wall
/// reads 0.
inline double nearer_hit(const Segment& wall, Vec2 origin, Vec2 direction, double best) {
  const Vec2 w = wall.a - origin;
  const double signed_den = cross(direction, wall.u);
  const double sign = std::copysign(1.0, signed_den);  // a branch would be a coin's toss
  const double den = std::fabs(signed_den);
  const double along_ray = sign * cross(w, wall.u);
  const double along_wall = sign * cross(w, direction);
  if (den < kParallel) {
    if (along_ray > kRayTolerance || along_ray < -kRayTolerance) return best;
    const double to_a = dot(w, direction);
    const double to_b = to_a + wall.length * dot(wall.u, direction);
    const double near = to_a < to_b ? to_a : to_b;
    const double far = to_a < to_b ? to_b : to_a;
    if (far < -kRayTolerance || near >= best) return best;
    const double range = near > 0.0 ? near : 0.0;
    return range < best ? range : best;
  }
  const double slack = kRayTolerance * den;
  if (along_wall < -slack || along_wall > wall.length * den + slack) return best;
  // The factor is above the roundings of this test, so that the least range wins in any order.
  if (along_ray < -slack || along_ray > best * den * (1.0 + 1e-15)) return best;
  const double range = along_ray / den;
  return range <= 0.0 ? 0.0 : (range < best ? range : best);  // not -0
}

/// Same for a disc. From within the disc the range is 0.
inline double nearer_disc_hit(Vec2 centre, double radius, Vec2 origin, Vec2 direction,
                              double best) {
  const Vec2 w = centre - origin;
  const double c = norm_squared(w) - radius * radius;
  if (c <= 0.0) return best > 0.0 ? 0.0 : best;
  const double along = dot(w, direction);
  if (along <= 0.0) return best;
  const double across = cross(direction, w);
  const double half_chord_squared = radius * radius - across * across;
  if (half_chord_squared < 0.0) return best;
  const double range = along - std::sqrt(half_chord_squared);
  return range < best ? range : best;
}

/// Point of `wall` nearest to `p`.
inline Vec2 closest_point(const Segment& wall, Vec2 p) {
  double s = dot(p - wall.a, wall.u);
  s = s > 0.0 ? (s < wall.length ? s : wall.length) : 0.0;
  return wall.a + s * wall.u;
}

/// A motion at a smaller angle to a touching surface than this (radians) counts as parallel to it:
/// more than rounding makes of a parallel one (about 1e-13), and so little that a robot would have
/// to drive 10 km along a wall to use up kContactGap.
inline constexpr double kParallelAngle = 1e-11;

/// Returned by the contact functions when there is no contact on the way; > 1.
inline constexpr double kNoContact = 2.0;

/// Fraction of `motion` after which a point that starts at `from` comes within `reach` of the
/// origin: 0 … 1, or kNoContact. Inside already: 0 when the motion leads deeper, else kNoContact.
double disc_contact(Vec2 from, Vec2 motion, double reach);

/// Same for a point at `from` and the capsule of radius `reach` around `wall`.
double wall_contact(const Segment& wall, Vec2 from, Vec2 motion, double reach);

}  // namespace eyebridge::world
