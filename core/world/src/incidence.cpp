#include <algorithm>
#include <cmath>

#include "world_impl.hpp"

namespace eyebridge::world {
namespace {

/// A place this near to a surface (metres) is on it: far more than a range's rounding, far less
/// than anything that a sensor tells apart.
constexpr double kOnSurface = 1e-6;

/// Of a ray along `direction` that ended at `place`, on the rim of a box or next to it.
double box_incidence(const Rectangle& box, Vec2 place, Vec2 direction) {
  const Vec2 p = box.local(place);
  const Vec2 d{std::abs(dot(direction, box.u)), std::abs(cross(box.u, direction))};
  const double beyond_x = std::abs(p.x) - box.half.x;
  const double beyond_y = std::abs(p.y) - box.half.y;
  double best = 0.0;
  if (std::abs(beyond_x) < kOnSurface && beyond_y < kOnSurface) best = d.x;
  if (std::abs(beyond_y) < kOnSurface && beyond_x < kOnSurface) best = std::max(best, d.y);
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
    if (bodies.box_among(id, id)) {
      best = std::max(best, box_incidence(bodies.rectangle(id), place, direction));
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
