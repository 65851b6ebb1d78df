#include "sweep.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#include "eyebridge/base/units.hpp"
#include "sweep_bearings.hpp"

namespace eyebridge::world {

Sweep::Sweep(Vec2 origin, std::span<const Vec2> directions, double gap, double max_range)
    : origin_(origin),
      count_(directions.size()),
      per_gap_(1.0 / std::fabs(gap)),
      period_(2 * kPi * per_gap_),
      turn_(gap > 0.0 ? 1.0 : -1.0) {
  assert(count_ > 0 && count_ <= kMost && gap != 0.0);
  for (std::size_t i = 0; i < count_; ++i) {
    dx[i] = directions[i].x;
    dy[i] = directions[i].y;
    best[i] = max_range;
  }
  for (std::size_t i = count_; i < count_ + kBeyond; ++i) {
    dx[i] = dx[0];
    dy[i] = dy[0];
    best[i] = 0.0;
  }
}

#define EYEBRIDGE_RAY_TARGET
#define EYEBRIDGE_RAY_LANES 2
#define EYEBRIDGE_OF(name) name##_scalar
#include "sweep_discs.ipp"
#include "sweep_walls.ipp"

}  // namespace eyebridge::world
