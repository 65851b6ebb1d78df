// Bearings of places in registers. They only tell which rays may meet what: no range depends on
// them.

/// Directions of ray 0 and, times the turn of the rays, of the same; in all lanes.
struct Directions {
  Floats x, turned_x, y, turned_y;
};

HWY_INLINE Directions directions(Vec2 first, double turn) {
  return {filled(static_cast<float>(first.x)), filled(static_cast<float>(turn * first.x)),
          filled(static_cast<float>(first.y)), filled(static_cast<float>(turn * first.y))};
}

constexpr float kHalfTurn = 3.14159274F;

/// first + s (next + s (…)).
HWY_INLINE Floats polynomial(Floats, float last) { return filled(last); }
template <class... More>
HWY_INLINE Floats polynomial(Floats s, float first, More... more) {
  return filled(first) + s * polynomial(s, more...);
}

/// The bearing of (x, y), 0 … 2 pi, by that of the same in the octant next to the x axis.
HWY_INLINE Floats out_of_octant(Floats angle, Floats x, Floats y) {
  const Floats zero = hn::Zero(kFloat);
  angle = hn::IfThenElse(hn::Abs(x) <= hn::Abs(y), filled(kHalfTurn / 2) - angle, angle);
  angle = hn::IfThenElse(x < zero, filled(kHalfTurn) - angle, angle);
  return hn::IfThenElse(y < zero, filled(2 * kHalfTurn) - angle, angle);
}

struct Bearing {
  Floats angle;     ///< From ray 0, in the direction in which rays are counted, 0 … 2 pi.
  Floats nearness;  ///< 1 by the distance, or up to sqrt(2) times as much.
};

/// Of places seen from the origin, within 1.2e-5 radians; as in Sweep::number_of().
HWY_INLINE Bearing bearing_of(Floats px, Floats py, const Directions& ahead) {
  const Floats x = ahead.x * px + ahead.y * py;
  const Floats y = ahead.turned_x * py - ahead.turned_y * px;
  const Floats ax = hn::Abs(x);
  const Floats ay = hn::Abs(y);
  const Floats nearness = filled(1.0F) / hn::Max(ax, ay);
  const Floats q = hn::Min(ax, ay) * nearness;
  const Floats angle =
      q * polynomial(q * q, 0.9998660F, -0.3302995F, 0.1801410F, -0.0851330F, 0.0208351F);
  return {out_of_octant(angle, x, y), nearness};
}

/// The same bearing, of places `1 / inverse` away, in fewer steps.
HWY_INLINE Floats rough_bearing_of(Floats px, Floats py, Floats inverse, const Directions& ahead) {
  const Floats x = ahead.x * px + ahead.y * py;
  const Floats y = ahead.turned_x * py - ahead.turned_y * px;
  const Floats sine = hn::Min(hn::Abs(x), hn::Abs(y)) * inverse;
  // The arc sine, within 1.7e-4 up to 45 degrees: least squares, weighted until all errors were
  // alike.
  const Floats angle = sine * polynomial(sine * sine, 1.00153222F, 0.1451349F, 0.1456058F);
  return out_of_octant(angle, x, y);
}
