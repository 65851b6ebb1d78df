#include "world_impl.hpp"

namespace eyebridge::world {

double World::Impl::convex_pair_contact(BodyId id, BodyId other, Vec2 motion) const {
  const bool moves = bodies.is_convex(id);
  if (moves && bodies.is_convex(other)) {
    return convex_contact(bodies.convex(id), bodies.convex(other), motion, kContactGap);
  }
  if (moves) {  // as seen from it the disc comes
    return disc_convex_contact(bodies.convex(id), bodies.position(other), -1.0 * motion,
                               bodies.radius_[other] + kContactGap);
  }
  return disc_convex_contact(bodies.convex(other), bodies.position(id), motion,
                             bodies.radius_[id] + kContactGap);
}

World::Impl::Obstacle World::Impl::first_wall_of_convex(BodyId id, Vec2 motion) {
  const double length = norm(motion);
  double& clearance = bodies.clearance_[id];
  if (length < clearance) return {};
  const Vec2 centre = bodies.position(id);
  const Convex shape = bodies.convex(id);
  Obstacle first;
  if (walls.inside_thick(centre)) return first;  // it may leave on any side
  const double reach = bodies.radius_[id] + kContactGap;
  double nearest = reach + length + bodies.radius_[id];
  walls.each_near(centre, nearest, [&](std::uint32_t segment, double distance) {
    if (distance < nearest) nearest = distance;
    const double fraction =
        convex_contact(shape, Convex(walls.segments()[segment]), motion, kContactGap);
    if (fraction < first.fraction || (fraction == first.fraction && segment < first.segment)) {
      first = {fraction, true, segment, kNoBody};
    }
  });
  clearance = nearest - reach - kContactGap;
  return first;
}

Vec2 World::Impl::towards_convex(const Obstacle& obstacle, BodyId id) const {
  const Vec2 centre = bodies.position(id);
  if (!bodies.is_convex(id)) {
    return direction_to(closest_point(bodies.convex(obstacle.body), centre), centre);
  }
  const Convex own = bodies.convex(id);
  if (obstacle.wall) return separation(own, Convex(walls.segments()[obstacle.segment])).normal;
  if (bodies.is_convex(obstacle.body)) {
    return separation(own, bodies.convex(obstacle.body)).normal;
  }
  const Vec2 other = bodies.position(obstacle.body);
  return direction_to(other, closest_point(own, other));
}

double World::Impl::gap_to_point(BodyId id, Vec2 p) const {
  return bodies.is_convex(id) ? distance_to(bodies.convex(id), p)
                              : norm(bodies.position(id) - p) - bodies.radius_[id];
}

}  // namespace eyebridge::world
