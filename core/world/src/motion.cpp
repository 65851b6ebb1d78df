#include <array>

#include "world_impl.hpp"

namespace eyebridge::world {
namespace {

/// How many pushed bodies a robot can meet in one step, and how many can push each other in a row.
constexpr int kMaxPushes = 8;

/// A pushed body goes this much farther than its pusher, so that rounding does not let them touch
/// again within the step, metres. Far below kContactGap.
constexpr double kPushLead = 1e-9;

/// How far beyond the step walls are looked for, in radii of the body.
constexpr double kLookAhead = 1.0;

/// What is squeezed against a wall slips aside unless the sine of the angle between the push and
/// the wall's normal is less than this: friction holds it then.
constexpr double kJamSine = 0.2;

}  // namespace

World::Impl::Obstacle World::Impl::first_wall(BodyId id, Vec2 motion) {
  if (bodies.is_convex(id)) return first_wall_of_convex(id, motion);
  const double length = norm(motion);
  double& clearance = bodies.clearance_[id];
  if (length < clearance) return {};
  const Vec2 from = bodies.position(id);
  Hold& hold = bodies.hold_[id];
  if (hold.from == from && hold.motion == motion && hold.body == kNoBody) {
    return {0.0, true, hold.segment, kNoBody};
  }
  const double reach = bodies.radius_[id] + kContactGap;
  // Looking beyond the step pays off: in the open the walls are asked only now and then.
  const double horizon = reach + length + kLookAhead * bodies.radius_[id];
  const WallIndex::Approach approach = walls.approach(from, motion, length, reach, horizon);
  clearance = approach.distance - reach - kPushLead;
  if (approach.fraction == 0.0) {
    hold = {from, motion, {}, approach.segment, kNoBody, {}, 0};
    hold.contact = towards({0.0, true, approach.segment, kNoBody}, id);
  }
  return {approach.fraction, true, approach.segment, kNoBody};
}

World::Impl::Obstacle World::Impl::first_obstacle(BodyId id, Vec2 motion) {
  const Obstacle wall = first_wall(id, motion);
  const Obstacle body = first_bodies(id, motion, [](BodyId) { return true; }).first;
  return body.fraction < wall.fraction ? body : wall;
}

void World::Impl::travel(BodyId id, Vec2 motion, double length) {
  bodies.travel_to(id, bodies.position(id) + motion, length);
  // The factor is more than the rounding of the length.
  bodies.clearance_[id] -= length * (1.0 + 1e-12);
}

Vec2 World::Impl::towards(const Obstacle& obstacle, BodyId id) const {
  if (bodies.convex_among(id, obstacle.wall ? id : obstacle.body)) {
    return towards_convex(obstacle, id);
  }
  const Vec2 p = bodies.position(id);
  return direction_to(obstacle.wall ? closest_point(walls.segments()[obstacle.segment], p)
                                    : bodies.position(obstacle.body),
                      p);
}

void World::Impl::kick(BodyId id, Vec2 velocity, Vec2 normal) {
  const Vec2 own = bodies.velocity(id);
  const double approach = dot(velocity - own, normal);
  if (approach > 0.0) {
    bodies.set_velocity(id, own + (1.0 + bodies.response_[id].kick) * approach * normal);
  }
}

bool World::Impl::slip(BodyId id, Vec2 motion, Vec2 normal) {
  const Vec2 along = motion - dot(motion, normal) * normal;
  const double sine_squared = norm_squared(along) / norm_squared(motion);
  if (!(sine_squared > kJamSine * kJamSine)) return false;
  // So far that the pusher, too, can go its way: the part of this along `motion` is `motion`.
  const Vec2 way = (1.0 / sine_squared) * along;
  const Obstacle end = first_obstacle(id, way);
  travel(id, (end.met() ? end.fraction : 1.0) * way);
  return !end.met();
}

double World::Impl::shift(BodyId id, Vec2 motion, double dt, int depth) {
  const Obstacle first = first_obstacle(id, motion);
  if (!first.met()) {
    travel(id, motion);
    return 1.0;
  }
  const double before = first.fraction;
  travel(id, before * motion);
  note(id, first);
  if (first.wall || !gives_way(first.body)) {
    return slip(id, (1.0 - before) * motion, towards(first, id)) ? 1.0 : before;
  }
  if (depth == 0) return before;
  // The next one gives way along the line of centres; this one follows as far as it went.
  const Vec2 rest = (1.0 - before) * motion;
  const Vec2 normal = towards(first, id);
  const double push = dot(rest, normal);
  if (bodies.response_[first.body].slides && dt > 0.0) {
    kick(first.body, (1.0 / dt) * motion, normal);
  }
  if (shift(first.body, (push + kPushLead) * normal, dt, depth - 1) < 1.0) return before;
  const Obstacle again = first_obstacle(id, rest);
  const double after = again.met() ? again.fraction : 1.0;
  travel(id, after * rest);
  return again.met() ? before + after * (1.0 - before) : 1.0;
}

MoveResult World::Impl::drive(BodyId id, Vec2 motion, double dt) {
  double done = 0.0;
  Vec2 rest = motion;
  std::array<BodyId, kMaxPushes> stuck{};
  std::size_t stuck_count = 0;
  const auto is_stuck = [&](BodyId other) {
    for (std::size_t i = 0; i < stuck_count; ++i) {
      if (stuck[i] == other) return true;
    }
    return false;
  };
  for (int pushes = 0;; ++pushes) {
    Obstacle end = first_wall(id, rest);
    if (end.fraction == 0.0) return stopped(id, done, end);  // no body can be nearer
    const auto [blocker, pushed] = first_bodies(id, rest, [&](BodyId other) {
      return !gives_way(other) || pushes >= kMaxPushes || is_stuck(other);
    });
    if (blocker.fraction < end.fraction) end = blocker;
    if (pushed.met() && pushed.fraction < end.fraction) {
      const double way = end.met() ? end.fraction : 1.0;
      const Vec2 push_motion = (way - pushed.fraction) * rest;
      travel(id, pushed.fraction * rest);
      done += pushed.fraction * (1.0 - done);
      rest = (1.0 - pushed.fraction) * rest;
      note(id, pushed);
      const Vec2 normal = towards(pushed, id);
      if (bodies.response_[pushed.body].slides && dt > 0.0) {
        kick(pushed.body, (1.0 / dt) * motion, normal);
      }
      const double push = dot(push_motion, normal) + kPushLead;
      if (shift(pushed.body, push * normal, dt, kMaxPushes) < 1.0)
        stuck[stuck_count++] = pushed.body;
      continue;
    }
    if (!end.met()) {
      travel(id, rest);
      return {};
    }
    travel(id, end.fraction * rest);
    const MoveResult result = stopped(id, done + end.fraction * (1.0 - done), end);
    const bool held = pushes == 0 && result.fraction == 0.0 && !end.wall;
    if (held && !bodies.convex_among(id, end.body)) {
      const Vec2 place = bodies.position(end.body);
      bodies.hold_[id] = {bodies.position(id), motion, result.contact, 0, end.body, place, 0};
    }
    return result;
  }
}

bool World::Impl::still_holds(const Hold& hold) const {
  if (hold.body == kNoBody) return true;
  return bodies.position(hold.body) == hold.place && !gives_way(hold.body);
}

MoveResult World::Impl::stopped(BodyId id, double fraction, const Obstacle& end) {
  note(id, end);
  return {fraction, end.wall, end.body, towards(end, id), fraction};
}

MoveResult World::move(BodyId id, const Arc& arc, double dt, const ContactLaw& law) {
  Bodies& bodies = impl_->bodies;
  const Heading before{bodies.cos_[id], bodies.sin_[id]};
  MoveResult result;
  if (arc.displacement != Vec2{}) {
    const Vec2 motion = before.rotate(arc.displacement);
    Hold& hold = bodies.hold_[id];
    const double length = norm(motion);
    if (length < bodies.clearance_[id] && bodies.is_alone(id, length)) {
      impl_->travel(id, motion, length);
    } else if (hold.motion == motion && hold.from == bodies.position(id) &&
               impl_->still_holds(hold)) {
      hold.round = bodies.round();
      result = {0.0, hold.body == kNoBody, hold.body, hold.contact, 0.0};
    } else {
      result = impl_->drive(id, motion, dt);
      if (law.slides && result.blocked()) impl_->slide(id, motion, dt, law.friction, result);
    }
  }
  Heading turn = arc.turn;
  if (!law.turns && result.progress < 1.0) {
    if (result.progress == 0.0) return result;
    turn = Heading::from_angle(result.progress * arc.turn.angle());
  }
  const Heading after = before.turned(turn);
  // One step of Newton's method for 1/sqrt keeps the length at 1 without a root.
  const double scale = 1.5 - 0.5 * (after.cos * after.cos + after.sin * after.sin);
  bodies.cos_[id] = scale * after.cos;
  bodies.sin_[id] = scale * after.sin;
  return result;
}

}  // namespace eyebridge::world
