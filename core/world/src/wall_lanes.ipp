// The walls of a WallList in registers. Included by the sources of one instruction set, as
// ray_lanes.ipp is.

#ifndef EYEBRIDGE_WALL_LANES_IPP
#define EYEBRIDGE_WALL_LANES_IPP

#include "ray_lanes.ipp"

namespace {

/// Nearer than this to a wall's line (metres) no bearing of its ends is trusted.
constexpr float kNear = 1e-3F;

/// Ends of walls, seen from where rays begin, metres. Lanes beyond the last wall hold no numbers.
struct Ends {
  Floats ax, ay, bx, by;
  Floats area;      ///< Positive where b is to the left of a, seen from there.
  Floats length;    ///< Up to sqrt(2) times as much.
  FloatBits along;  ///< Set where rays begin so near the wall's line that they all may meet it.
};

/// Of the register that begins with the wall `k` of the list.
EYEBRIDGE_RAY_TARGET inline Ends ends_of(const WallList& walls, std::size_t k, Vec2 origin) {
  const auto x0 = static_cast<float>(origin.x - walls.centre.x);
  const auto y0 = static_cast<float>(origin.y - walls.centre.y);
  const auto error = static_cast<float>(walls.error);
  Ends ends;
  ends.ax = load(walls.ends + k) - x0;
  ends.ay = load(walls.ends + walls.stride + k) - y0;
  ends.bx = load(walls.ends + 2 * walls.stride + k) - x0;
  ends.by = load(walls.ends + 3 * walls.stride + k) - y0;
  ends.area = ends.ax * ends.by - ends.ay * ends.bx;
  // There the tolerances of rays are wide angles: the area by the length.
  ends.length = magnitude(ends.ax - ends.bx) + magnitude(ends.ay - ends.by);
  const Floats size =
      (magnitude(ends.ax) + magnitude(ends.ay)) * (magnitude(ends.bx) + magnitude(ends.by));
  ends.along = magnitude(ends.area) <= (kNear + 2 * error) * ends.length + 1e-5F * size;
  return ends;
}

}  // namespace

#endif
