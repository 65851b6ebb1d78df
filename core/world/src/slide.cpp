#include "world_impl.hpp"

// What becomes of a driven body's motion after it met something: ContactLaw.

namespace eyebridge::world {
namespace {

/// The most surfaces that a body slides along in one step: a bend of a wall, a body beside it.
constexpr int kMostSlides = 4;

/// The gap, metres, at which a body slides along a wall, so that rounding does not hold it there.
constexpr double kSlideLead = 1e-9;

/// The part of `motion` that goes on along what lies in the direction of `normal`.
Vec2 slide_of(Vec2 motion, Vec2 normal, double friction) {
  const double into = dot(motion, normal);
  const Vec2 along = motion - into * normal;
  const double length = norm(along);
  const double rest = length - friction * into;
  return rest > 0.0 ? (rest / length) * along : Vec2{};
}

}  // namespace

void World::Impl::slide(BodyId id, Vec2 motion, double dt, double friction, MoveResult& result) {
  const Hold hold = bodies.hold_[id];
  bool tried = false;
  bool among_walls = result.hit_wall;
  Vec2 made = result.fraction * motion;
  double left = 1.0 - result.fraction;
  Vec2 normal = result.contact;
  Vec2 left_behind;
  for (int i = 0; i < kMostSlides && normal != Vec2{}; ++i) {
    const Vec2 way = slide_of(left * motion, normal, friction);
    // In a corner it would go back into what it came from.
    if (way == Vec2{} || dot(way, left_behind) > 0.0) break;
    const MoveResult next = drive(id, way - kSlideLead * normal, dt);
    tried = true;
    made = made + next.fraction * way;
    if (next.fraction > 0.0) result.slid = true;
    if (!next.blocked()) break;
    among_walls = among_walls && next.hit_wall;
    left *= 1.0 - next.fraction;
    left_behind = normal;
    normal = next.contact;
  }
  // In a corner of walls the whole motion fails again. Of other things what held it last may go
  // away without a change of what it met first.
  if (tried) bodies.hold_[id] = among_walls ? hold : Hold{};
  if (!result.slid) return;
  result.progress = std::clamp(dot(made, motion) / norm_squared(motion), 0.0, 1.0);
}

}  // namespace eyebridge::world
