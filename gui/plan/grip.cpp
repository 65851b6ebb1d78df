#include "plan/grip.hpp"

#include <algorithm>

namespace eyebridge::gui {
std::optional<Grip> grip_at(const hal::WorldLook& look, Vec2 place, double slack) {
  std::optional<Grip> found;
  double nearest = 0.0;
  for (const world::BodyView& body : look.scene.bodies) {
    const double away = norm(place - body.pose.position());
    if (world::rim_distance(body, place) > slack || (found && away >= nearest)) continue;
    nearest = away;
    const auto object = std::ranges::find(look.objects, body.id);
    const auto number = static_cast<std::size_t>(object - look.objects.begin());
    found = Grip{body.id, {}, number, body.pose, place, false};
    const auto robot = std::ranges::find(look.robots, body.id, &hal::RobotLook::body);
    if (robot == look.robots.end()) continue;
    found->robot = static_cast<std::size_t>(robot - look.robots.begin());
    found->turns = away > kRimShare * body.radius;
  }
  return found;
}

Pose moved(const Grip& grip, Vec2 place) {
  const Vec2 centre = grip.start.position();
  if (!grip.turns) {
    const Vec2 to = centre + (place - grip.hold);
    return {to.x, to.y, grip.start.theta};
  }
  const Vec2 from = grip.hold - centre;
  const Vec2 now = place - centre;
  const double turn = arc_tan2(cross(from, now), dot(from, now));
  return {centre.x, centre.y, wrap_angle(grip.start.theta + turn)};
}

}  // namespace eyebridge::gui
