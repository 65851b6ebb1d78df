#pragma once

#include <algorithm>
#include <utility>

#include "convex.hpp"
#include "eyebridge/world/world.hpp"

namespace eyebridge::world {

inline bool is_convex(const World& world, BodyId id) {
  return world.shape(id) == BodyShape::Polygon;
}

inline Convex convex_at(const World& world, BodyId id) {
  return {Outline(corners_of(world.model().objects[id])), world.position(id),
          world.heading(id).forward()};
}

/// How deep two bodies stand in each other, metres; less than 0 when they are apart.
inline double overlap(const World& world, BodyId a, BodyId b) {
  if (is_convex(world, a) && is_convex(world, b)) {
    return -separation(convex_at(world, a), convex_at(world, b)).distance;
  }
  if (is_convex(world, a)) std::swap(a, b);
  if (is_convex(world, b)) {
    return world.radius(a) - distance_to(convex_at(world, b), world.position(a));
  }
  return world.radius(a) + world.radius(b) - norm(world.position(a) - world.position(b));
}

/// How deep the deepest body stands in a wall or another body, metres; 0 when none does. By a loop
/// over everything.
inline double deepest_of_all(const World& world) {
  double deepest = 0.0;
  const std::vector<Segment> walls = outlines_of(world.model().walls);
  for (BodyId id = 0; id < world.body_count(); ++id) {
    for (BodyId other = 0; other < id; ++other) {
      deepest = std::max(deepest, overlap(world, id, other));
    }
    const Vec2 p = world.position(id);
    for (const Segment& wall : walls) {
      const double gap = is_convex(world, id)
                             ? separation(convex_at(world, id), Convex(wall)).distance
                             : norm(p - closest_point(wall, p)) - world.radius(id);
      deepest = std::max(deepest, -gap);
    }
  }
  return deepest;
}

}  // namespace eyebridge::world
