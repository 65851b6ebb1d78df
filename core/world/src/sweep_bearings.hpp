#pragma once

#include <cmath>

#include "sweep.hpp"

namespace eyebridge::world {

/// Bearings are this good, radians: the arc tangent below, and what the tolerance of rays beyond a
/// wall's end (kRayTolerance) makes where a wall is not nearly along the rays.
inline constexpr double kBearingError = 3e-5;

/// Largest error of rough_bearing_of(), radians, and largest relative error of inverse_root_of().
inline constexpr double kRoughError = 6e-4;

/// Rays that are looked at to either side beyond what bearings say, for the rounding of numbers of
/// rays.
inline constexpr double kRayMargin = 1e-3;

inline double Sweep::number_of(Vec2 p) const {
  const double x = dx[0] * p.x + dy[0] * p.y;
  const double y = turn * (dx[0] * p.y - dy[0] * p.x);
  const double ax = std::fabs(x);
  const double ay = std::fabs(y);
  // Abramowitz and Stegun 4.4.49: within 1e-5 for 0 … 1. Only picks rays; no range depends on it.
  const double q = ax > ay ? ay / ax : ax / ay;
  const double s = q * q;
  double angle =
      q * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))));
  constexpr double kHalfTurn = 3.141592653589793;
  angle = ax > ay ? angle : kHalfTurn / 2 - angle;
  angle = x < 0.0 ? kHalfTurn - angle : angle;
  return (y < 0.0 ? 2 * kHalfTurn - angle : angle) * per_gap;
}

template <class Visit>
inline void Sweep::each_between(double from, double to, Visit visit) const {
  const auto last = static_cast<double>(count - 1);
  const auto run = [&](double first_ray, double last_ray) {
    const double f = first_ray > 0.0 ? first_ray : 0.0;
    const double l = last_ray < last ? last_ray : last;
    if (!(f <= l)) return;
    // One too many at the start, where it is not whole.
    visit(static_cast<std::size_t>(f), static_cast<std::size_t>(l));
  };
  if (!(to - from < period)) {  // all round
    visit(0, count - 1);
    return;
  }
  // The same rays, a turn before, at and a turn after their numbers.
  run(from, to);
  if (from < 0.0) run(from + period, to + period);
  if (to >= period) run(from - period, to - period);
}

}  // namespace eyebridge::world
