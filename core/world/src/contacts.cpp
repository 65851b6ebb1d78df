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

void ContactBook::forget(BodyId body) {
  std::erase_if(pairs_, [&](const Pair& pair) { return pair.a == body || pair.b == body; });
}

void World::Impl::note(BodyId id, const Obstacle& end) {
  const Vec2 centre = bodies.position(id);
  Vec2 place = centre + bodies.radius_[id] * towards(end, id);
  if (bodies.shape_[id] == BodyShape::Box) {
    const Vec2 met =
        end.wall ? closest_point(walls.segments()[end.segment], centre) : bodies.position(end.body);
    place = closest_point(bodies.rectangle(id), met);
  }
  contacts.note({id, end.wall ? kNoBody : end.body, place});
}

double World::Impl::gap(BodyId id, BodyId other) const {
  if (other == kNoBody) return wall_gap(id);
  const bool box = bodies.shape_[id] == BodyShape::Box;
  if (box && bodies.shape_[other] == BodyShape::Box) {
    return separation(bodies.rectangle(id), bodies.rectangle(other)).distance;
  }
  if (box) return gap_to_point(id, bodies.position(other)) - bodies.radius_[other];
  return gap_to_point(other, bodies.position(id)) - bodies.radius_[id];
}

double World::Impl::wall_gap(BodyId id) const {
  const Vec2 centre = bodies.position(id);
  if (bodies.hold_[id].from == centre) return 0.0;  // it stands where a wall held it
  const double radius = bodies.radius_[id];
  const double limit = radius + 2 * ContactBook::kReleaseGap;  // farther ones need no number
  if (bodies.shape_[id] != BodyShape::Box) return walls.distance(centre, limit) - radius;
  double least = std::numeric_limits<double>::infinity();
  walls.each_near(centre, limit, [&](std::uint32_t segment, double) {
    const Rectangle wall = rectangle_of(walls.segments()[segment]);
    least = std::min(least, separation(bodies.rectangle(id), wall).distance);
  });
  return least;
}

std::span<const Bump> World::bumps() const { return impl_->contacts.begun(); }

}  // namespace eyebridge::world
