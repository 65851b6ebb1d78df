#include "arc.hpp"

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
  double sine_by_angle = 0.0;
  double versine_by_angle = 0.0;
  Heading turn;
  if (std::abs(a) < kSeriesLimit) {
    const double z = a * a;
    sine_by_angle =
        1.0 - z / 6.0 * (1.0 - z / 20.0 * (1.0 - z / 42.0 * (1.0 - z / 72.0 * (1.0 - z / 110.0))));
    versine_by_angle =
        a / 2.0 *
        (1.0 -
         z / 12.0 * (1.0 - z / 30.0 * (1.0 - z / 56.0 * (1.0 - z / 90.0 * (1.0 - z / 132.0)))));
    turn = {1.0 - a * versine_by_angle, a * sine_by_angle};
  } else {
    const SinCos sc = sin_cos(a);
    sine_by_angle = sc.sin / a;
    versine_by_angle = (1.0 - sc.cos) / a;
    turn = {sc.cos, sc.sin};
  }
  return {{path.distance * sine_by_angle, path.distance * versine_by_angle}, turn};
}

}  // namespace eyebridge::robot
