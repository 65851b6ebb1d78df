#include "eyebridge/robot/arc.hpp"

#include <cmath>

#include "eyebridge/base/math.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kSeriesLimit = 0.25;  // radians; the first term left out is below 1e-17

}  // namespace

world::Arc arc_of(const PathStep& path) {
  // A chord of an arc of length d and angle a, seen from its start:
  // x = d sin(a) / a, y = d (1 - cos(a)) / a. Both quotients are smooth through a = 0.
  const double a = path.angle;
  // What the series below gives for it, to the bit.
  if (a == 0.0) return {{path.distance, path.distance * (0.5 * a)}, {1.0, a}};
  double sine_by_angle = 0.0;
  double versine_by_angle = 0.0;
  Heading turn;
  if (std::abs(a) < kSeriesLimit) {
    const double z = a * a;
    double sine = -1.0 / 39916800.0;  // 1/11!
    sine = sine * z + 1.0 / 362880.0;
    sine = sine * z - 1.0 / 5040.0;
    sine = sine * z + 1.0 / 120.0;
    sine = sine * z - 1.0 / 6.0;
    sine_by_angle = 1.0 + z * sine;
    double versine = -1.0 / 479001600.0;  // 1/12!
    versine = versine * z + 1.0 / 3628800.0;
    versine = versine * z - 1.0 / 40320.0;
    versine = versine * z + 1.0 / 720.0;
    versine = versine * z - 1.0 / 24.0;
    versine_by_angle = a * (0.5 + z * versine);
    turn = {1.0 - a * versine_by_angle, a * sine_by_angle};
  } else {
    const SinCos sc = sin_cos(a);
    sine_by_angle = sc.sin / a;
    versine_by_angle = (1.0 - sc.cos) / a;
    turn = {sc.cos, sc.sin};
  }
  return {{path.distance * sine_by_angle, path.distance * versine_by_angle}, turn};
}

world::Arc sideways_screw_of(const BodyStep& step) {
  // The chord is linear in the speed, and what it does to one to the left is what it does to one
  // forward, turned by a quarter.
  world::Arc arc = arc_of(PathStep{1.0, step.angle});
  const Vec2 unit = arc.displacement;
  arc.displacement = {step.forward * unit.x - step.left * unit.y,
                      step.forward * unit.y + step.left * unit.x};
  return arc;
}

}  // namespace eyebridge::robot
