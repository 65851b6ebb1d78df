#include "sweep.hpp"

#include <cassert>
#include <cmath>

#include "eyebridge/base/units.hpp"

namespace eyebridge::world {

Sweep::Sweep(Vec2 from, std::span<const Vec2> directions, double gap, double max_range)
    : origin(from),
      count(directions.size()),
      per_gap(1.0 / std::fabs(gap)),
      period(2 * kPi * per_gap),
      turn(gap > 0.0 ? 1.0 : -1.0) {
  assert(count > 0 && count <= kMost && gap != 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    dx[i] = directions[i].x;
    dy[i] = directions[i].y;
    best[i] = max_range;
  }
  for (std::size_t i = count; i < count + kBeyond; ++i) {
    dx[i] = dx[0];
    dy[i] = dy[0];
    best[i] = 0.0;
  }
}

}  // namespace eyebridge::world
