#pragma once

#include <cmath>
#include <cstddef>

#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world_model.hpp"
#include "text.hpp"

namespace eyebridge::files {

/// Most walls and starts of a world.
inline constexpr std::size_t kMostWalls = 500000;
inline constexpr std::size_t kMostStarts = 10000;

/// Whether `place` is farther from an axis than any file may say, or not finite.
inline bool is_too_far(Vec2 place) {
  const double most = mm_to_m(kMaxMillimetres);
  return !(std::fabs(place.x) <= most) || !(std::fabs(place.y) <= most);
}

/// Adds `wall` if it has a length. For one too many, and one too far away, it calls
/// `refuse(std::string)`, which does not return.
template <class Refuse>
void add_wall(world::WorldModel& model, const world::Wall& wall, Refuse refuse) {
  if (wall.a == wall.b) return;
  if (model.walls.size() >= kMostWalls) refuse("more than 500000 walls");
  if (is_too_far(wall.a) || is_too_far(wall.b)) refuse("lies more than 10 km from the origin");
  model.walls.push_back(wall);
}

}  // namespace eyebridge::files
