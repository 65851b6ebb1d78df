#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

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

/// Neither infinite nor NaN, which fails every comparison.
bool is_positive(double value) { return value > 0.0 && std::isfinite(value); }
bool is_not_negative(double value) { return value >= 0.0 && std::isfinite(value); }

void check(const Path& path) {
  check(is_positive(path.speed) && !path.points.empty(), "object: a path needs a speed and points");
  check(is_not_negative(path.acceleration),
        "object: the acceleration on a path must be finite and not negative");
  for (const Vec2 point : path.points) {
    check(std::isfinite(point.x) && std::isfinite(point.y), "object: a way-point must be finite");
  }
  check(path.leg_speeds.size() <= path.leg_count() && path.waits.size() <= path.leg_count(),
        "object: more speeds or waits than legs of the path");
  for (const double speed : path.leg_speeds)
    check(is_positive(speed), "object: a leg needs a speed");
  for (const double wait : path.waits)
    check(is_not_negative(wait), "object: a wait must be finite and not negative");
}

}  // namespace

void check_object(const ObjectSpec& object) {
  const Matter& matter = object.matter;
  check(is_positive(object.outer_radius()), "object: the size must be positive");
  check(is_not_negative(object.height), "object: the height must be finite and not negative");
  check(object.kind != ObjectKind::Box || (object.size.x > 0.0 && object.size.y > 0.0),
        "object: length and width of a box must be positive");
  if (object.kind == ObjectKind::Polygon) {
    if (const auto fault = fault_of_corners(object.corners)) {
      throw std::invalid_argument("object: corner " + std::to_string(fault->corner + 1) +
                                  " of the polygon: expected " + fault->expected);
    }
  }
  check(is_positive(matter.mass), "object: the mass must be positive");
  if (object.path) check(*object.path);
  check(!object.path || !object.reaction, "object: a path and a reaction: expected one of them");
  check(!object.reaction || (is_positive(object.reaction->speed) && object.reaction->range >= 0.0),
        "object: a reaction needs a speed and a range");
  check(is_not_negative(object.yields_within),
        "object: it yields within a distance, which is not negative");
  check(!matter.friction || is_not_negative(*matter.friction),
        "object: friction must be finite and not negative");
  check(!matter.restitution || (*matter.restitution >= 0.0 && *matter.restitution <= 1.0),
        "object: restitution must be 0 to 1");
}

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

BodyId World::Impl::add_object(const ObjectSpec& object) {
  check_object(object);
  const BodyId id = bodies.add(shape_of(object.kind), object.pose.position(),
                               Heading::from_angle(object.pose.theta), object.outer_radius(),
                               object.height, object.colour);
  bodies.response_[id] = response_of(object);
  things.push_back({id, object});
  note_slider(id);
  if (object.path) add_mover(id, object);
  if (object.reaction) add_reactor(id, object);
  if (!bodies.is_convex(id)) return id;
  bodies.outline_[id] = std::make_shared<const Outline>(corners_of(object));
  bodies.any_convex_ = true;
  return id;
}

void World::Impl::note_slider(BodyId id) {
  const auto at = std::ranges::lower_bound(sliders, id);
  const bool is_noted = at != sliders.end() && *at == id;
  const bool slides = bodies.response_[id].slides;
  if (slides && !is_noted) sliders.insert(at, id);
  if (!slides && is_noted) sliders.erase(at);
}

}  // namespace eyebridge::world
