#include <stdexcept>

#include "world_impl.hpp"

namespace eyebridge::world {
namespace {

/// Rolling friction slows a ball of no given friction by this much, metres per second squared.
constexpr double kRollingDeceleration = 0.3;

/// What a ball of no given restitution keeps of its speed when it bounces, and what it gets of the
/// speed of approach when something driven hits it.
constexpr double kBounceRestitution = 0.6;
constexpr double kKickRestitution = 0.5;

void check(bool good, const char* what) {
  if (!good) throw std::invalid_argument(what);
}

/// Written so that NaN fails, too.
void check(const Path& path) {
  check(path.speed > 0.0 && !path.points.empty(), "object: a path needs a speed and points");
  check(path.acceleration >= 0.0, "object: the acceleration on a path must not be negative");
  check(path.leg_speeds.size() <= path.leg_count() && path.waits.size() <= path.leg_count(),
        "object: more speeds or waits than legs of the path");
  for (const double speed : path.leg_speeds) check(speed > 0.0, "object: a leg needs a speed");
  for (const double wait : path.waits) check(wait >= 0.0, "object: a wait must not be negative");
}

}  // namespace

void check_object(const ObjectSpec& object) {
  const Matter& matter = object.matter;
  check(object.outer_radius() > 0.0, "object: the size must be positive");
  check(object.kind != ObjectKind::Box || (object.size.x > 0.0 && object.size.y > 0.0),
        "object: length and width of a box must be positive");
  check(matter.mass > 0.0, "object: the mass must be positive");
  if (object.path) check(*object.path);
  check(!object.path || !object.reaction, "object: a path and a reaction: expected one of them");
  check(!object.reaction || (object.reaction->speed > 0.0 && object.reaction->range >= 0.0),
        "object: a reaction needs a speed and a range");
  check(object.yields_within >= 0.0, "object: it yields within a distance, which is not negative");
  check(!matter.friction || *matter.friction >= 0.0, "object: friction must not be negative");
  check(!matter.restitution || (*matter.restitution >= 0.0 && *matter.restitution <= 1.0),
        "object: restitution must be 0 to 1");
}

namespace {

Response response_of(const ObjectSpec& object) {
  const Matter& matter = object.matter;
  const bool ball = object.kind == ObjectKind::Ball;
  Response out;
  out.gives_way = !matter.fixed && !object.path && !object.reaction;
  out.slides = out.gives_way && (ball || matter.friction);
  out.mass = matter.mass;
  out.deceleration = matter.friction ? *matter.friction * kGravity : kRollingDeceleration;
  out.bounce = matter.restitution.value_or(ball ? kBounceRestitution : 0.0);
  out.kick = matter.restitution.value_or(ball ? kKickRestitution : 0.0);
  return out;
}

}  // namespace

BodyShape shape_of(ObjectKind kind) {
  if (kind == ObjectKind::Ball) return BodyShape::Ball;
  return kind == ObjectKind::Can ? BodyShape::Can : BodyShape::Box;
}

BodyId World::Impl::add_object(const ObjectSpec& object) {
  check_object(object);
  const BodyId id = bodies.add(shape_of(object.kind), object.pose.position(),
                               Heading::from_angle(object.pose.theta), object.outer_radius(),
                               object.height, object.colour);
  bodies.response_[id] = response_of(object);
  things.push_back({id, object});
  if (object.path) add_mover(id, object);
  if (object.reaction) add_reactor(id, object);
  if (object.kind != ObjectKind::Box) return id;
  bodies.half_[id] = 0.5 * object.size;
  bodies.any_box_ = true;
  return id;
}

void World::Impl::set_fixed(Thing& thing, bool fixed) {
  thing.changed = true;
  thing.spec.matter.fixed = fixed;
  bodies.response_[thing.body] = response_of(thing.spec);
  if (fixed) bodies.set_velocity(thing.body, {});
}

}  // namespace eyebridge::world
