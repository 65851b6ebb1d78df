#include "eyebridge/planning/pure_pursuit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "eyebridge/base/units.hpp"

namespace eyebridge::planning {
namespace {

void check(const PurePursuitSettings& settings) {
  const auto positive = [](double value, const char* complaint) {
    if (!(value > 0.0)) throw std::invalid_argument(complaint);
  };
  positive(settings.lookahead, "pure pursuit: lookahead must be > 0");
  positive(settings.speed, "pure pursuit: speed must be > 0");
  positive(settings.max_angular, "pure pursuit: max_angular must be > 0");
  positive(settings.deceleration, "pure pursuit: deceleration must be > 0");
  positive(settings.tolerance, "pure pursuit: tolerance must be > 0");
}

}  // namespace

PurePursuit::PurePursuit(std::vector<Vec2> points, const PurePursuitSettings& settings)
    : progress_(std::move(points)), settings_(settings) {
  check(settings);
}

Twist PurePursuit::follow(const Pose& pose) {
  const Vec2 position = pose.position();
  progress_.advance(position, 2.0 * settings_.lookahead);
  const double left = norm(progress_.end() - position);
  arrived_ = left <= settings_.tolerance && progress_.remaining() <= settings_.lookahead;
  if (arrived_) return {};
  Vec2 aim = progress_.leaving_circle(position, settings_.lookahead);
  // A path that comes back before it has left the circle: its end is no aim yet.
  if (aim == progress_.end() && progress_.remaining() > settings_.lookahead) {
    aim = progress_.ahead(settings_.lookahead);
  }
  const Vec2 local = Heading::from_angle(-pose.theta).rotate(aim - position);
  const double distance = norm(local);
  if (local.x < 0.5 * distance) {
    // A right angle or more off: as fast as it may; slower towards the end, so as not to swing
    // past.
    const double share = arc_tan2(local.y, local.x) / (kPi / 2);
    return {0.0, settings_.max_angular * std::clamp(share, -1.0, 1.0)};
  }
  const double curvature = distance > 0.0 ? 2.0 * local.y / (distance * distance) : 0.0;
  const double to_go = std::max(progress_.remaining(), left);
  double speed = std::min(settings_.speed, std::sqrt(2.0 * settings_.deceleration * to_go));
  if (std::abs(curvature) * speed > settings_.max_angular) {
    speed = settings_.max_angular / std::abs(curvature);
  }
  const double angular =
      std::clamp(curvature * speed, -settings_.max_angular, settings_.max_angular);
  return {speed, angular};
}

}  // namespace eyebridge::planning
