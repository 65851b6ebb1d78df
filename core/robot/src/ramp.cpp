#include "eyebridge/robot/ramp.hpp"

#include <algorithm>
#include <cmath>

namespace eyebridge::robot {
namespace {

double rim_speed(const Twist& twist, const DriveLimits& limits) {
  return std::abs(twist.linear) + std::abs(twist.angular) * limits.half_base;
}

}  // namespace

Twist clamp_twist(const Twist& twist, const DriveLimits& limits) {
  Twist out{std::clamp(twist.linear, -limits.linear, limits.linear),
            std::clamp(twist.angular, -limits.angular, limits.angular)};
  const double rim = rim_speed(out, limits);
  if (rim > limits.wheel) {
    out.linear *= limits.wheel / rim;
    out.angular *= limits.wheel / rim;
  }
  return out;
}

Twist approach(const Twist& from, const Twist& to, const DriveLimits& limits) {
  const Twist apart{
      std::clamp(to.linear, from.linear - limits.linear_step, from.linear + limits.linear_step),
      std::clamp(to.angular, from.angular - limits.angular_step,
                 from.angular + limits.angular_step)};
  constexpr double kRimRounding = 1.0 + 1e-12;
  if (rim_speed(apart, limits) <= limits.wheel * kRimRounding) return apart;
  // The twists that the wheels can do are a convex set that holds both ends, so the straight way
  // between them is allowed where the two parts on their own are not.
  const double linear = std::abs(to.linear - from.linear);
  const double angular = std::abs(to.angular - from.angular);
  double part = 1.0;
  if (linear > limits.linear_step) part = std::min(part, limits.linear_step / linear);
  if (angular > limits.angular_step) part = std::min(part, limits.angular_step / angular);
  return {from.linear + part * (to.linear - from.linear),
          from.angular + part * (to.angular - from.angular)};
}

double stopping_share(double share) {
  // Speeds v, v - b, v - 2b, …, down to the last positive one (n + 1 steps, b = a dt) cover
  // dt ((n + 1) v - b n (n + 1) / 2). Solved for v where that is all that is left; n is the
  // largest number for which v >= n b.
  const double n = std::floor((std::sqrt(1.0 + 8.0 / share) - 1.0) / 2.0);
  if (n < 1.0) return 1.0;
  return (1.0 + share * n * (n + 1.0) / 2.0) / (n + 1.0);
}

}  // namespace eyebridge::robot
