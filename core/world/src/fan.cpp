#include "fan.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#include "fan_pairs.hpp"

namespace eyebridge::world {
namespace {

/// The rays of the second half look the other way of those of the first, but for so much.
constexpr double kOpposite = 1e-9;

}  // namespace

Fan::Fan(Vec2 origin, std::span<const Vec2> directions, double max_range, std::uint32_t self)
    : origin_(origin), self_(self), directions_(directions), lines_(directions.size()) {
  assert(!directions.empty() && directions.size() <= kMost);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    dx_[i] = directions[i].x;
    dy_[i] = directions[i].y;
    x_[i] = static_cast<float>(directions[i].x);
    y_[i] = static_cast<float>(directions[i].y);
    best_[i] = max_range;
  }
  for (std::size_t i = directions.size(); i % 8 != 0; ++i) {
    dx_[i] = dy_[i] = 0.0;
    x_[i] = y_[i] = std::numeric_limits<float>::quiet_NaN();
    best_[i] = max_range;
  }
  if (directions.size() % 2 == 0) {
    const std::size_t half = directions.size() / 2;
    double most = 0.0;
    for (std::size_t i = 0; i < half; ++i) {
      const Vec2 sum = directions[i] + directions[half + i];
      const double off = std::fabs(sum.x) + std::fabs(sum.y);
      most = off > most ? off : most;
    }
    if (most <= kOpposite) lines_ = half;
  }
}

#define EYEBRIDGE_RAY_TARGET
#define EYEBRIDGE_RAY_LANES 2
#define EYEBRIDGE_OF(name) name##_scalar
#include "fan.ipp"

}  // namespace eyebridge::world
