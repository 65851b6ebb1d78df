#pragma once

#include <cmath>

#include "sweep.hpp"

namespace eyebridge::world {

/// Nearer than this to a wall (metres) no bearing is trusted.
inline constexpr double kNear = 1e-3;
inline constexpr float kNearFloat = 1e-3F;

/// Bearings are this good, radians: the arc tangent below, and what the tolerance of rays beyond a
/// wall's end (kRayTolerance) makes at kNear.
inline constexpr double kBearingError = 3e-5;

inline double Sweep::bearing_of(Vec2 p) const {
  const double x = dx[0] * p.x + dy[0] * p.y;
  const double y = turn_ * (dx[0] * p.y - dy[0] * p.x);
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
  return y < 0.0 ? 2 * kHalfTurn - angle : angle;
}

template <class Visit>
inline void Sweep::each_between(double low, double high, double wider, Visit visit) const {
  constexpr double kTurn = 6.283185307179586;
  if (high < low) high += kTurn;
  const double period = kTurn * per_gap_;
  const double margin = 1e-3 + (wider + kBearingError) * per_gap_;
  const double from = low * per_gap_ - margin;
  const double to = high * per_gap_ + margin;
  // The same rays, a turn before, at and a turn after their numbers; from < period, and to >= 0.
  const auto last = static_cast<double>(count_ - 1);
  const auto run = [&](double first_ray, double last_ray) {
    const double f = first_ray > 0.0 ? first_ray : 0.0;
    const double l = last_ray < last ? last_ray : last;
    if (!(f <= l)) return;
    // One too many at the start, where it is not whole.
    visit(static_cast<std::size_t>(f), static_cast<std::size_t>(l));
  };
  if (!(to - from < period)) {  // all round
    visit(0, count_ - 1);
    return;
  }
  run(from, to);
  if (from < 0.0) run(from + period, to + period);
  if (to >= period) run(from - period, to - period);
}

}  // namespace eyebridge::world
