#include "world_impl.hpp"

namespace eyebridge::world {
namespace {

/// A body bounces at most this often in a step; it loses the rest of the step's way then.
constexpr int kMaxBounces = 4;

}  // namespace

void World::Impl::roll(BodyId id, double dt) {
  const double speed = norm(bodies.velocity(id));
  if (speed == 0.0 || dt <= 0.0) return;
  const double deceleration = bodies.response_[id].deceleration;
  const double loss = deceleration * dt;
  const double slower = speed > loss ? speed - loss : 0.0;
  const double rolling = speed > loss ? dt : speed / deceleration;
  // The way is driven at the starting velocity, in the time that makes it as long as the real one.
  double left = rolling * (speed + slower) / (2 * speed);
  for (int bounce = 0; bounce <= kMaxBounces && left > 0.0; ++bounce) {
    const Vec2 velocity = bodies.velocity(id);
    const Vec2 motion = left * velocity;
    const Obstacle end = first_obstacle(id, motion);
    if (!end.met()) {
      travel(id, motion);
      break;
    }
    travel(id, end.fraction * motion);
    left -= end.fraction * left;
    note(id, end);
    bounce_off(id, end);
  }
  const double after = norm(bodies.velocity(id));
  if (after > 0.0) {
    const double kept = after > loss ? (after - loss) / after : 0.0;
    bodies.set_velocity(id, kept * bodies.velocity(id));
  }
}

void World::Impl::bounce_off(BodyId id, const Obstacle& end) {
  const Vec2 velocity = bodies.velocity(id);
  const Vec2 normal = towards(end, id);
  const Response& own = bodies.response_[id];
  if (!end.wall && bodies.response_[end.body].slides) {
    const Response& other = bodies.response_[end.body];
    const double bounce = own.bounce > other.bounce ? own.bounce : other.bounce;
    const double total = own.mass + other.mass;
    const double approach = dot(velocity - bodies.velocity(end.body), normal);
    if (approach <= 0.0) return;
    // The momentum of both stays; the lighter one takes the larger change of velocity.
    const auto change = [&](double mass) {
      return (mass / total * (1.0 + bounce) * approach) * normal;
    };
    bodies.set_velocity(id, velocity - change(other.mass));
    bodies.set_velocity(end.body, bodies.velocity(end.body) + change(own.mass));
    return;
  }
  const double approach = dot(velocity, normal);
  if (approach > 0.0) {
    bodies.set_velocity(id, velocity - (1.0 + own.bounce) * approach * normal);
  }
}

void World::step_objects(double dt) {
  for (Mover& mover : impl_->movers) impl_->follow(mover, dt);
  for (Reactor& reactor : impl_->reactors) impl_->react(reactor, dt);
  for (const BodyId id : impl_->sliders) impl_->roll(id, dt);
  impl_->contacts.end_step([&](BodyId id, BodyId other) { return impl_->gap(id, other); },
                           [&](BodyId id, BodyId other) { impl_->end_contact(id, other); });
  impl_->bodies.end_round();
}

}  // namespace eyebridge::world
