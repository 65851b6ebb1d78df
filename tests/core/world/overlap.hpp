#pragma once

#include <algorithm>
#include <utility>

#include "boxes.hpp"
#include "eyebridge/world/world.hpp"

namespace eyebridge::world {

inline bool is_box(const World& world, BodyId id) {
  return id < world.object_count() && world.model().objects[id].kind == ObjectKind::Box;
}

inline Rectangle rectangle_at(const World& world, BodyId id) {
  return {world.position(id), world.heading(id).forward(), 0.5 * world.model().objects[id].size};
}

/// How deep two bodies stand in each other, metres; less than 0 when they are apart.
inline double overlap(const World& world, BodyId a, BodyId b) {
  if (is_box(world, a) && is_box(world, b)) {
    return -separation(rectangle_at(world, a), rectangle_at(world, b)).distance;
  }
  if (is_box(world, a)) std::swap(a, b);
  if (is_box(world, b)) {
    return world.radius(a) - distance_to(rectangle_at(world, b), world.position(a));
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
      const double gap = is_box(world, id)
                             ? separation(rectangle_at(world, id), rectangle_of(wall)).distance
                             : norm(p - closest_point(wall, p)) - world.radius(id);
      deepest = std::max(deepest, -gap);
    }
  }
  return deepest;
}

}  // namespace eyebridge::world
