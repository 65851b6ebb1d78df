// Bearings of places, a register of them at a time, and as numbers of rays that are counted from a
// first one. Included by the sources of one instruction set, as ray_lanes.ipp is. They only tell
// who may meet whom: no range depends on them.

#ifndef EYEBRIDGE_BEARING_LANES_IPP
#define EYEBRIDGE_BEARING_LANES_IPP

#include "twice.ipp"

namespace {

/// Directions of ray 0 and, times the turn of the rays, of the same.
struct Directions {
  float x, turned_x, y, turned_y;
};

inline Directions directions(Vec2 first, double turn) {
  return {static_cast<float>(first.x), static_cast<float>(turn * first.x),
          static_cast<float>(first.y), static_cast<float>(turn * first.y)};
}

constexpr float kHalfTurn = 3.14159274F;

/// The bearing of (x, y), 0 ... 2 pi, by that of the same in the octant next to the x axis.
template <class Values>
EYEBRIDGE_RAY_TARGET inline Values out_of_octant(Values angle, Values x, Values y) {
  angle = either(magnitude(x) <= magnitude(y), kHalfTurn / 2 - angle, angle);
  angle = either(x < 0.0F, kHalfTurn - angle, angle);
  return either(y < 0.0F, 2 * kHalfTurn - angle, angle);
}

struct Bearing {
  Floats angle;     ///< From ray 0, in the direction in which rays are counted, 0 … 2 pi.
  Floats nearness;  ///< 1 by the distance, or up to sqrt(2) times as much.
};

/// Of places seen from the origin, within 1.2e-5 radians; as in Sweep::number_of().
EYEBRIDGE_RAY_TARGET inline Bearing bearing_of(Floats px, Floats py, const Directions& ahead) {
  const Floats x = ahead.x * px + ahead.y * py;
  const Floats y = ahead.turned_x * py - ahead.turned_y * px;
  const Floats ax = magnitude(x);
  const Floats ay = magnitude(y);
  const Floats nearness = 1.0F / larger(ax, ay);
  const Floats q = smaller(ax, ay) * nearness;
  const Floats s = q * q;
  const Floats angle =
      q * (0.9998660F + s * (-0.3302995F + s * (0.1801410F + s * (-0.0851330F + s * 0.0208351F))));
  return {out_of_octant(angle, x, y), nearness};
}

/// No bearing by rough_bearing_of() is off by more, radians, and no root by inverse_root_of() by a
/// larger part.
constexpr float kRoughError = 6e-4F;

/// The same bearing, of places `1 / inverse` away, in fewer steps.
template <class Values>
EYEBRIDGE_RAY_TARGET inline Values rough_bearing_of(Values px, Values py, Values inverse,
                                                    const Directions& ahead) {
  const Values x = ahead.x * px + ahead.y * py;
  const Values y = ahead.turned_x * py - ahead.turned_y * px;
  const Values sine = smaller(magnitude(x), magnitude(y)) * inverse;
  const Values s = sine * sine;
  // The arc sine, within 1.7e-4 up to 45 degrees: least squares, weighted until all errors were
  // alike.
  const Values angle = sine * (1.00153222F + s * (0.1451349F + s * 0.1456058F));
  return out_of_octant(angle, x, y);
}

}  // namespace

#endif
