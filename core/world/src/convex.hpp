#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/world/world_model.hpp"
#include "geometry.hpp"

namespace eyebridge::world {

/// The outline of a thing in its own frame, corners counter-clockwise.
struct Outline {
  explicit Outline(std::vector<Vec2> its_corners);

  std::vector<Vec2> corners;  ///< Metres.
  std::vector<Vec2> normals;  ///< Outward unit vectors: [i] of the edge that begins at corners[i].
};

/// A convex polygon anywhere in the plane: a box or polygon seen from above, or a wall's segment,
/// whose ends are edges of no length: what slides along another wall is not caught by them.
struct Convex {
  /// `outline`, its origin at `place`, its x axis along the unit vector `u`.
  Convex(const Outline& outline, Vec2 place, Vec2 u);
  explicit Convex(const Segment& wall);

  [[nodiscard]] std::span<const Vec2> corners() const { return {corner.data(), count}; }
  [[nodiscard]] Segment edge(std::size_t i) const;
  /// How far beyond edge `i` `p` lies, metres; less than 0 on the inner side.
  [[nodiscard]] double beyond(std::size_t i, Vec2 p) const { return dot(normal[i], p - corner[i]); }

  std::array<Vec2, kMostCorners> corner;
  std::array<Vec2, kMostCorners> normal;  ///< As in Outline.
  std::size_t count;
};

/// Point of `shape` nearest to `p`; `p` itself within it.
Vec2 closest_point(const Convex& shape, Vec2 p);
/// Distance from `p` to the rim of `shape`, metres; within it less than 0.
double distance_to(const Convex& shape, Vec2 p);

/// How far apart two of them are along the axis that separates them best, metres, and that axis, a
/// unit vector from `a` to `b`. Less than 0 when they overlap. Less than their distance where two
/// corners are nearest.
struct Separation {
  double distance = 0.0;
  Vec2 normal;
};
Separation separation(const Convex& a, const Convex& b);

/// Where on the rim of `a` it touches `b`, which lies in the direction of the unit vector `normal`:
/// the middle of what touches.
Vec2 contact_place(const Convex& a, const Convex& b, Vec2 normal);

/// Range along the ray (`direction` is a unit vector) to `shape` where that is less than `best`,
/// else `best`. From within the shape the range is 0.
double nearer_convex_hit(const Convex& shape, Vec2 origin, Vec2 direction, double best);

/// Fraction of `motion` after which a disc's centre that starts at `from` comes within `reach` of
/// `shape`: 0 ... 1, or kNoContact. One that a person put into the shape may leave it on any side.
double disc_convex_contact(const Convex& shape, Vec2 from, Vec2 motion, double reach);

/// Fraction of `motion`, of `a`, after which `a` comes within `gap` of `b`: where a point enters
/// their Minkowski difference, by the method of separating axes (C. Ericson, "Real-Time Collision
/// Detection", sections 5.2 and 5.5). Those that overlap already may only go apart.
double convex_contact(const Convex& a, const Convex& b, Vec2 motion, double gap);

}  // namespace eyebridge::world
