#include "reactions.hpp"

#include "eyebridge/base/units.hpp"
#include "world_impl.hpp"

namespace eyebridge::world {
namespace {

/// Streams of a run's seed that no device of a robot has: with the number of the body.
constexpr std::uint64_t kWanderStream = std::uint64_t{1} << 62U;

/// What wanders leaves an obstacle as a mirror would send it, turned by up to this, radians: a
/// mirror alone would keep it on one line between two walls for good.
constexpr double kScatter = kPi / 4;

}  // namespace

void World::Impl::add_reactor(BodyId id, const ObjectSpec& object) {
  Reactor reactor{id, *object.reaction, object.yields_within, Random(seed, kWanderStream + id)};
  if (reactor.reaction.kind == Reaction::Kind::Wander) {
    reactor.direction = Heading::from_angle(2 * kPi * reactor.random.uniform()).forward();
  }
  reactors.push_back(reactor);
}

BodyId World::Impl::nearest_robot(BodyId id, double range) const {
  BodyId nearest = kNoBody;
  double least = range;
  const Vec2 own = bodies.position(id);
  bodies.each_on_way(own, {}, bodies.radius_[id] + range, [&](BodyId other) {
    if (bodies.shape_[other] != BodyShape::Robot) return;
    const double distance = gap_to_point(id, bodies.position(other)) - bodies.radius_[other];
    if (distance > least || (distance == least && other > nearest)) return;
    nearest = other;
    least = distance;
  });
  return nearest;
}

void World::Impl::react(Reactor& reactor, double dt) {
  const BodyId id = reactor.body;
  const Reaction& reaction = reactor.reaction;
  if (reactor.yields_within > 0.0 && nearest_robot(id, reactor.yields_within) != kNoBody) return;
  const double way = reaction.speed * dt;
  if (reaction.kind == Reaction::Kind::Wander) {
    const MoveResult result = drive(id, way * reactor.direction, dt);
    if (!result.blocked()) return;
    ++reactor.bounces;
    const double into = dot(reactor.direction, result.contact);
    const Vec2 mirrored = reactor.direction - 2 * into * result.contact;
    const Heading scatter = Heading::from_angle(kScatter * (2 * reactor.random.uniform() - 1));
    // Not into the obstacle again, however grazing the mirrored way is.
    const Vec2 turned = scatter.rotate(mirrored);
    reactor.direction = dot(turned, result.contact) < 0.0 ? turned : mirrored;
    // Unit vectors stay so, bounce after bounce.
    reactor.direction = (1.0 / norm(reactor.direction)) * reactor.direction;
    return;
  }
  const BodyId robot = nearest_robot(id, reaction.range);
  if (robot == kNoBody) return;
  const Vec2 towards_it = direction_to(bodies.position(robot), bodies.position(id));
  const bool follows = reaction.kind == Reaction::Kind::Follow;
  const Vec2 motion = (follows ? way : -way) * towards_it;
  const MoveResult result = drive(id, motion, dt);
  if (!result.blocked() || result.hit_body == robot) return;
  // What stands in its way is passed along its face; the rest of the step's way that leads there.
  const Vec2 rest = (1.0 - result.fraction) * motion;
  const Vec2 along = rest - dot(rest, result.contact) * result.contact;
  if (along != Vec2{}) drive(id, along, dt);
}

}  // namespace eyebridge::world
