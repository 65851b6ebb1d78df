#include "contacts.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "world_impl.hpp"

namespace eyebridge::world {

void ContactBook::note(const Bump& bump) {
  const Pair pair{std::min(bump.body, bump.other), std::max(bump.body, bump.other)};
  const auto place = std::lower_bound(
      pairs_.begin(), pairs_.end(), pair,
      [](const Pair& p, const Pair& q) { return std::tie(p.a, p.b) < std::tie(q.a, q.b); });
  if (place != pairs_.end() && place->a == pair.a && place->b == pair.b) {
    place->noted = true;
    return;
  }
  pairs_.insert(place, pair);
  coming_.push_back(bump);
}

void World::Impl::note(BodyId id, const Obstacle& end) {
  const Vec2 normal = towards(end, id);
  Vec2 place = bodies.position(id) + bodies.radius_[id] * normal;
  if (bodies.is_convex(id)) {
    const Convex own = bodies.convex(id);
    if (end.wall) {
      place = contact_place(own, Convex(walls.segments()[end.segment]), normal);
    } else if (bodies.is_convex(end.body)) {
      place = contact_place(own, bodies.convex(end.body), normal);
    } else {
      place = closest_point(own, bodies.position(end.body));
    }
  }
  contacts.note({id, end.wall ? kNoBody : end.body, place});
}

void World::Impl::end_contact(BodyId id, BodyId other) {
  Hold& hold = bodies.hold_[id];
  if (hold.body == other) hold = {};
  if (other != kNoBody && bodies.hold_[other].body == id) bodies.hold_[other] = {};
}

double World::Impl::gap(BodyId id, BodyId other) const {
  if (other == kNoBody) return wall_gap(id);
  // They were not noted where one of them was known to hold the other one.
  const auto held = [&](const Hold& hold, BodyId by) {
    return hold.body == by && hold.round == bodies.round();
  };
  if (held(bodies.hold_[id], other) || held(bodies.hold_[other], id)) return 0.0;
  const bool convex = bodies.is_convex(id);
  if (convex && bodies.is_convex(other)) {
    return separation(bodies.convex(id), bodies.convex(other)).distance;
  }
  if (convex) return gap_to_point(id, bodies.position(other)) - bodies.radius_[other];
  return gap_to_point(other, bodies.position(id)) - bodies.radius_[id];
}

double World::Impl::wall_gap(BodyId id) const {
  const Vec2 centre = bodies.position(id);
  const Hold& hold = bodies.hold_[id];
  if (hold.from == centre && hold.body == kNoBody) return 0.0;  // it stands where a wall held it
  const double radius = bodies.radius_[id];
  const double limit = radius + 2 * ContactBook::kReleaseGap;  // farther ones need no number
  if (!bodies.is_convex(id)) return walls.distance(centre, limit) - radius;
  double least = std::numeric_limits<double>::infinity();
  const Convex own = bodies.convex(id);
  walls.each_near(centre, limit, [&](std::uint32_t segment, double) {
    least = std::min(least, separation(own, Convex(walls.segments()[segment])).distance);
  });
  return least;
}

std::span<const Bump> World::bumps() const { return impl_->contacts.begun(); }

}  // namespace eyebridge::world
