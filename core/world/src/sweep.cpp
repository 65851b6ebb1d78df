#include "sweep.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#include "sweep_bearings.hpp"

namespace eyebridge::world {

Sweep::Sweep(Vec2 origin, std::span<const Vec2> directions, double gap, double max_range)
    : origin_(origin), count_(directions.size()) {
  assert(count_ <= kMost);
  for (std::size_t i = 0; i < count_; ++i) {
    dx[i] = directions[i].x;
    dy[i] = directions[i].y;
    best[i] = max_range;
  }
  for (std::size_t i = count_; i % 4 != 0; ++i) {  // the last register is full, too
    dx[i] = dx[0];
    dy[i] = dy[0];
    best[i] = max_range;
  }
  // Few rays are tried faster than they are found.
  if (gap != 0.0 && count_ > kFew) {
    per_gap_ = 1.0 / std::fabs(gap);
    turn_ = gap > 0.0 ? 1.0 : -1.0;
  }
}

#define EYEBRIDGE_RAY_TARGET
#define EYEBRIDGE_RAY_LANES 2
#define EYEBRIDGE_MEET_WALLS meet_walls_scalar
#define EYEBRIDGE_MEET_DISCS meet_discs_scalar
#define EYEBRIDGE_MEET_ROWS meet_rows_scalar
#include "ray_lanes.ipp"
#include "sweep.ipp"

}  // namespace eyebridge::world
