// How far rays get, all together. Included by one source per instruction set, as ray_lanes.ipp is.

#ifndef EYEBRIDGE_RAY_EXTENT_IPP
#define EYEBRIDGE_RAY_EXTENT_IPP

#include "ray_lanes.ipp"

namespace {

/// No body is farther away than this, metres: infinite ranges need an end.
constexpr double kLongestRay = 1e9;

/// For the rounding of ends of rays, metres.
constexpr double kExtentMargin = 1e-6;

/// Two corners of a box.
struct Extent {
  Vec2 low, high;
};

/// Of what `count` rays that begin at `origin` and end at `best` pass, and `margin` metres more.
/// The arrays are filled up to a whole register.
EYEBRIDGE_RAY_TARGET inline Extent extent_of(Vec2 origin, const double* dx, const double* dy,
                                             const double* best, std::size_t count, double margin) {
  Lanes low_x{};
  Lanes low_y{};
  Lanes high_x{};
  Lanes high_y{};
  for (std::size_t i = 0; i < count; i += kLanes) {
    Lanes x;
    Lanes y;
    Lanes range;
    load(x, dx + i);
    load(y, dy + i);
    load(range, best + i);
    range = range < kLongestRay ? range : Lanes{} + kLongestRay;
    x *= range;
    y *= range;
    low_x = x < low_x ? x : low_x;
    low_y = y < low_y ? y : low_y;
    high_x = x > high_x ? x : high_x;
    high_y = y > high_y ? y : high_y;
  }
  Extent all{{0.0, 0.0}, {0.0, 0.0}};
  for (std::size_t i = 0; i < kLanes; ++i) {
    all.low.x = low_x[i] < all.low.x ? low_x[i] : all.low.x;
    all.low.y = low_y[i] < all.low.y ? low_y[i] : all.low.y;
    all.high.x = high_x[i] > all.high.x ? high_x[i] : all.high.x;
    all.high.y = high_y[i] > all.high.y ? high_y[i] : all.high.y;
  }
  return {origin + all.low - Vec2{margin, margin}, origin + all.high + Vec2{margin, margin}};
}

}  // namespace

#endif
