#include <optional>

#include "simulation_impl.hpp"

namespace eyebridge::robot {
namespace {

/// A kicker strikes when its servo comes from below to this position: three quarters of its throw,
/// so that it is drawn back at the middle, where servos start.
constexpr double kStrike = 0.75;

}  // namespace

bool strikes(const KickerModel& kicker, unsigned servo, double before, double after) {
  return servo == kicker.servo && before < kStrike && after >= kStrike;
}

void Simulation::Impl::strike(RobotIndex robot, const KickerModel& kicker) {
  const RobotState& state = at(robot);
  if (state.has_left) return;
  const Vec2 centre = world.position(state.body);
  const Vec2 forward = world.heading(state.body).forward();
  const double least_cosine = sin_cos(kicker.half_angle).cos;
  std::optional<world::BodyId> nearest;
  double least = kicker.reach;
  for (std::size_t i = 0; i < world.object_count(); ++i) {
    const world::BodyId id = world.object_body(i);
    const bool ball = world.shape(id) == world::BodyShape::Ball;
    if (!ball || !world.gives_way(id)) continue;
    const Vec2 way = world.position(id) - centre;
    const double distance = norm(way);
    const double gap = distance - world.radius(state.body) - world.radius(id);
    if (gap > least || (nearest && gap == least)) continue;
    if (dot(way, forward) < least_cosine * distance) continue;
    nearest = id;
    least = gap;
  }
  if (!nearest) return;
  const double own = state.driven.linear > 0.0 ? state.driven.linear : 0.0;
  world.set_velocity(*nearest, (kicker.speed + own) * forward);
}

}  // namespace eyebridge::robot
