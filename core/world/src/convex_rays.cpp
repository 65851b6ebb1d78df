// Rays that meet boxes and polygons, where Sweep and Fan have found walls and discs.
#include <algorithm>
#include <cmath>

#include "eyebridge/base/math.hpp"
#include "sweep_bearings.hpp"
#include "world_impl.hpp"

namespace eyebridge::world {

void World::Impl::meet_convex(Sweep& sweep, BodyId ignore) const {
  const std::span<double> ranges = sweep.ranges();
  const double farthest = *std::max_element(ranges.begin(), ranges.end());
  bodies.each_on_way(sweep.origin, {}, std::min(farthest, kHorizon), [&](BodyId id) {
    if (id == ignore || !bodies.is_convex(id)) return;
    const Vec2 way = bodies.position(id) - sweep.origin;
    const double distance = norm(way);
    const double radius = bodies.radius_[id];
    const double nearest = distance - radius;
    if (nearest >= farthest) return;
    const Convex shape = bodies.convex(id);
    const auto meet = [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i <= last; ++i) {
        if (ranges[i] <= nearest) continue;
        ranges[i] = nearer_convex_hit(shape, sweep.origin, {sweep.dx[i], sweep.dy[i]}, ranges[i]);
      }
    };
    if (nearest <= 0.0) return meet(0, ranges.size() - 1);
    const double beside = std::sqrt(distance * distance - radius * radius);
    const double half = (arc_tan2(radius, beside) + kBearingError) * sweep.per_gap + kRayMargin;
    const double middle = sweep.number_of(way);
    sweep.each_between(middle - half, middle + half, meet);
  });
}

double World::Impl::nearer_body_hit(BodyId id, Vec2 origin, Vec2 direction, double best) const {
  // Most rays pass the disc around it.
  const Vec2 way = bodies.position(id) - origin;
  const double rounding = 1e-12 * (std::fabs(way.x) + std::fabs(way.y));
  if (std::fabs(cross(direction, way)) > bodies.radius_[id] + rounding) return best;
  return nearer_convex_hit(bodies.convex(id), origin, direction, best);
}

void World::Impl::meet_convex(const RayFan& fan) const {
  for (std::size_t i = 0; i < fan.directions.size(); ++i) {
    const Vec2 origin = fan.origins.empty() ? fan.origin : fan.origins[i];
    const double reach = std::min(fan.ranges[i], kHorizon);
    bodies.each_on_ray(origin, reach * fan.directions[i], [&](BodyId id) {
      if (id == fan.ignore || !bodies.is_convex(id)) return;
      fan.ranges[i] = nearer_body_hit(id, origin, fan.directions[i], fan.ranges[i]);
    });
  }
}

}  // namespace eyebridge::world
