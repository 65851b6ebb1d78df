#pragma once

#include <cstddef>
#include <vector>

#include "bodies.hpp"
#include "body_map.hpp"
#include "eyebridge/base/random.hpp"

namespace eyebridge::world {

/// A fan of evenly spaced rays.
struct Rays {
  Vec2 origin;
  std::vector<Vec2> directions;
  double gap;
};

/// `count` rays, `gap` radians apart, the first one at the bearing `start`.
inline Rays fan(Vec2 origin, double start, double gap, int count) {
  Rays made{origin, {}, gap};
  for (int i = 0; i < count; ++i) {
    made.directions.push_back(Heading::from_angle(start + i * gap).forward());
  }
  return made;
}

/// Bodies of a crowd, with a map of them.
struct Crowd {
  explicit Crowd(std::size_t count, Random& random, double largest = 0.12) {
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 place{4 * random.uniform(), 4 * random.uniform()};
      const double radius = largest * (0.15 + 0.85 * random.uniform());
      bodies.add(BodyShape::Robot, place, {}, radius, 0.1, {});
    }
    map.refresh(bodies);
  }

  Bodies bodies{4.0, 4.0};
  BodyMap map{4.0, 4.0};
};

}  // namespace eyebridge::world
