#include "world_impl.hpp"

namespace eyebridge::world {

double World::Impl::box_pair_contact(BodyId id, BodyId other, Vec2 motion) const {
  const bool moves = bodies.shape_[id] == BodyShape::Box;
  const bool stands = bodies.shape_[other] == BodyShape::Box;
  if (moves && stands) {
    return box_contact(bodies.rectangle(id), bodies.rectangle(other), motion, kContactGap);
  }
  if (moves) {  // as seen from it the disc comes
    return disc_box_contact(bodies.rectangle(id), bodies.position(other), -1.0 * motion,
                            bodies.radius_[other] + kContactGap);
  }
  return disc_box_contact(bodies.rectangle(other), bodies.position(id), motion,
                          bodies.radius_[id] + kContactGap);
}

World::Impl::Obstacle World::Impl::first_wall_of_box(BodyId id, Vec2 motion) {
  const double length = norm(motion);
  double& clearance = bodies.clearance_[id];
  if (length < clearance) return {};
  const Rectangle box = bodies.rectangle(id);
  Obstacle first;
  if (walls.inside_thick(box.centre)) return first;  // it may leave on any side
  const double reach = bodies.radius_[id] + kContactGap;
  double nearest = reach + length + bodies.radius_[id];
  walls.each_near(box.centre, nearest, [&](std::uint32_t segment, double distance) {
    if (distance < nearest) nearest = distance;
    const double fraction =
        box_contact(box, rectangle_of(walls.segments()[segment]), motion, kContactGap);
    if (fraction < first.fraction || (fraction == first.fraction && segment < first.segment)) {
      first = {fraction, true, segment, kNoBody};
    }
  });
  clearance = nearest - reach - kContactGap;
  return first;
}

Vec2 World::Impl::box_towards(const Obstacle& obstacle, BodyId id) const {
  const Rectangle own = bodies.rectangle(id);
  if (bodies.shape_[id] != BodyShape::Box) {
    return direction_to(closest_point(bodies.rectangle(obstacle.body), own.centre), own.centre);
  }
  if (obstacle.wall)
    return separation(own, rectangle_of(walls.segments()[obstacle.segment])).normal;
  const Rectangle other = bodies.rectangle(obstacle.body);
  if (bodies.shape_[obstacle.body] == BodyShape::Box) return separation(own, other).normal;
  return direction_to(other.centre, closest_point(own, other.centre));
}

double World::Impl::gap_to_point(BodyId id, Vec2 p) const {
  return bodies.shape_[id] == BodyShape::Box ? distance_to(bodies.rectangle(id), p)
                                             : norm(bodies.position(id) - p) - bodies.radius_[id];
}

}  // namespace eyebridge::world
