#pragma once

#include "eyebridge/base/pose.hpp"
#include "geometry.hpp"

namespace eyebridge::world {

/// A rectangle anywhere in the plane: a box seen from above, or a wall's segment (half.y = 0).
struct Rectangle {
  Vec2 centre;
  Vec2 u;     ///< Unit vector along its length.
  Vec2 half;  ///< Half its length and half its width, metres, >= 0.

  /// `p` as seen from the centre, with x along the length.
  [[nodiscard]] Vec2 local(Vec2 p) const { return {dot(p - centre, u), cross(u, p - centre)}; }
};

Rectangle rectangle_of(const Segment& wall);

/// Point of `box` nearest to `p`; `p` itself within it.
Vec2 closest_point(const Rectangle& box, Vec2 p);
/// Distance from `p` to the rim of `box`, metres; within it less than 0.
double distance_to(const Rectangle& box, Vec2 p);

/// How far apart two rectangles are along the axis that separates them best, metres, and that axis,
/// a unit vector from `a` to `b`. Less than 0 when they overlap. Less than their distance where two
/// corners are nearest.
struct Separation {
  double distance = 0.0;
  Vec2 normal;
};
Separation separation(const Rectangle& a, const Rectangle& b);

/// Range along the ray (`direction` is a unit vector) to `box` where that is less than `best`, else
/// `best`. From within the box the range is 0.
double nearer_box_hit(const Rectangle& box, Vec2 origin, Vec2 direction, double best);

/// Fraction of `motion` after which a disc's centre that starts at `from` comes within `reach` of
/// `box`: 0 ... 1, or kNoContact. One that a person put into the box may leave it on any side.
double disc_box_contact(const Rectangle& box, Vec2 from, Vec2 motion, double reach);

/// Fraction of `motion`, of `a`, after which `a` comes within `gap` of `b`, by the separating axis
/// theorem for moving convex polygons (D. Eberly, "Dynamic Collision Detection using Oriented
/// Bounding Boxes"). Those that overlap already may only go apart.
double box_contact(const Rectangle& a, const Rectangle& b, Vec2 motion, double gap);

}  // namespace eyebridge::world
