#include <algorithm>
#include <cmath>

#include "world_impl.hpp"

namespace eyebridge::world {
namespace {

/// A place this near to a surface (metres) is on it: far more than a range's rounding, far less
/// than anything that a sensor tells apart.
constexpr double kOnSurface = 1e-6;

/// Of a ray along `direction` that ended at `place`, on the rim of `shape` or next to it.
double convex_incidence(const Convex& shape, Vec2 place, Vec2 direction) {
  if (std::abs(distance_to(shape, place)) >= kOnSurface) return 0.0;
  double best = 0.0;
  for (std::size_t i = 0; i < shape.count; ++i) {
    if (std::abs(shape.beyond(i, place)) >= kOnSurface) continue;
    best = std::max(best, std::abs(dot(direction, shape.normal[i])));
  }
  return best;
}

}  // namespace

double World::incidence_cosine(Vec2 place, Vec2 direction, BodyId ignore) const {
  double best = 0.0;
  impl_->walls.each_near(place, kOnSurface, [&](std::uint32_t segment, double) {
    best = std::max(best, std::abs(cross(direction, impl_->walls.segments()[segment].u)));
  });
  const Bodies& bodies = impl_->bodies;
  bodies.each_on_way(place, {}, kOnSurface, [&](BodyId id) {
    if (id == ignore) return;
    if (bodies.convex_among(id, id)) {
      best = std::max(best, convex_incidence(bodies.convex(id), place, direction));
      return;
    }
    const Vec2 outward = place - bodies.position(id);
    const double distance = norm(outward);
    if (std::abs(distance - bodies.radius_[id]) >= kOnSurface) return;
    best = std::max(best, std::abs(dot(direction, outward)) / distance);
  });
  return std::min(best, 1.0);
}

}  // namespace eyebridge::world
