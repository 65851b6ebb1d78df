#include "world_impl.hpp"

namespace eyebridge::world {
namespace {

/// Rolling friction slows a ball by this much, metres per second per second.
constexpr double kRollingDeceleration = 0.3;

/// A ball leaves a wall, robot or can at this fraction of the speed that it came with.
constexpr double kBounceRestitution = 0.6;

/// A ball bounces at most this often in a step; it loses the rest of the step's way then.
constexpr int kMaxBounces = 4;

}  // namespace

void World::Impl::roll(BodyId ball, double dt) {
  const double speed = norm(bodies.velocity(ball));
  if (speed == 0.0 || dt <= 0.0) return;
  const double loss = kRollingDeceleration * dt;
  const double slower = speed > loss ? speed - loss : 0.0;
  const double rolling = speed > loss ? dt : speed / kRollingDeceleration;
  // The way is driven at the starting velocity, in the time that makes it as long as the real one.
  double left = rolling * (speed + slower) / (2 * speed);
  for (int bounce = 0; bounce <= kMaxBounces && left > 0.0; ++bounce) {
    const Vec2 velocity = bodies.velocity(ball);
    const Vec2 motion = left * velocity;
    const Obstacle end = first_obstacle(ball, motion);
    if (!end.met()) {
      travel(ball, motion);
      break;
    }
    travel(ball, end.fraction * motion);
    left -= end.fraction * left;
    bounce_off(ball, end);
  }
  const double after = norm(bodies.velocity(ball));
  if (after > 0.0) {
    const double kept = after > loss ? (after - loss) / after : 0.0;
    bodies.set_velocity(ball, kept * bodies.velocity(ball));
  }
}

void World::Impl::bounce_off(BodyId ball, const Obstacle& end) {
  const Vec2 velocity = bodies.velocity(ball);
  const Vec2 normal = towards(end, ball);
  if (!end.wall && bodies.shape_[end.body] == BodyShape::Ball) {
    // Two balls share the exchange as equal masses do.
    const double approach = dot(velocity - bodies.velocity(end.body), normal);
    if (approach <= 0.0) return;
    const Vec2 change = (0.5 * (1.0 + kBounceRestitution) * approach) * normal;
    bodies.set_velocity(ball, velocity - change);
    bodies.set_velocity(end.body, bodies.velocity(end.body) + change);
    return;
  }
  const double approach = dot(velocity, normal);
  if (approach > 0.0) {
    bodies.set_velocity(ball, velocity - (1.0 + kBounceRestitution) * approach * normal);
  }
}

void World::step_objects(double dt) {
  for (BodyId id = 0; id < impl_->bodies.size(); ++id) {
    if (impl_->bodies.shape_[id] == BodyShape::Ball) impl_->roll(id, dt);
  }
  impl_->bodies.end_round();
}

}  // namespace eyebridge::world
