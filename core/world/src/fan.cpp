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
/// And their lines are the same, but for so many metres: far less than any look is off.
constexpr float kOneLine = 1e-6F;
/// What the places of origins may be off by, metres: far less, too.
constexpr double kRounding = 1e-9;
constexpr double kLeastReach = 1.0 / 32;  // metres beyond the longest ray

}  // namespace

double Fan::reach_of(const RayFan& rays) {
  if (rays.origins.empty()) return rays.max_range;
  double beyond = kLeastReach;
  while (beyond < rays.spread) beyond *= 2;
  return rays.max_range + beyond;
}

Fan::Fan(const RayFan& rays, std::uint32_t self)
    : origin_(rays.origin),
      apart_(!rays.origins.empty()),
      spread_(apart_ ? rays.spread : 0.0),
      self_(self),
      directions_(rays.directions),
      lines_(rays.directions.size()) {
  const std::span<const Vec2> directions = directions_;
  assert(!directions.empty() && directions.size() <= kMost);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    dx_[i] = directions[i].x;
    dy_[i] = directions[i].y;
    x_[i] = static_cast<float>(directions[i].x);
    y_[i] = static_cast<float>(directions[i].y);
    best_[i] = rays.max_range;
  }
  for (std::size_t i = directions.size(); i % 8 != 0; ++i) {
    dx_[i] = dy_[i] = 0.0;
    x_[i] = y_[i] = std::numeric_limits<float>::quiet_NaN();
    best_[i] = rays.max_range;
  }
  if (apart_) place(rays.origins);
  if (directions.size() % 2 == 0) {
    const std::size_t half = directions.size() / 2;
    double most = 0.0;
    for (std::size_t i = 0; i < half; ++i) {
      const Vec2 sum = directions[i] + directions[half + i];
      const double off = std::fabs(sum.x) + std::fabs(sum.y);
      most = off > most ? off : most;
    }
    if (most <= kOpposite && have_one_line_each(half)) lines_ = half;
  }
}

void Fan::place(std::span<const Vec2> origins) {
  assert(origins.size() == directions_.size());
  for (std::size_t i = 0; i < origins.size(); ++i) {
    assert(norm(origins[i] - origin_) <= spread_ + kRounding);
    ox_[i] = origins[i].x;
    oy_[i] = origins[i].y;
    beside_[i] = static_cast<float>(cross(origins[i] - origin_, directions_[i]));
  }
  for (std::size_t i = origins.size(); i % 8 != 0; ++i) {
    ox_[i] = oy_[i] = 0.0;
    beside_[i] = 0.0F;
  }
}

bool Fan::have_one_line_each(std::size_t half) const {
  if (!apart_) return true;
  for (std::size_t i = 0; i < half; ++i) {
    if (std::fabs(beside_[i] + beside_[half + i]) > kOneLine) return false;
  }
  return true;
}

#define EYEBRIDGE_RAY_TARGET
#define EYEBRIDGE_RAY_LANES 2
#define EYEBRIDGE_OF(name) name##_scalar
#include "fan_discs.ipp"
#include "fan_walls.ipp"

}  // namespace eyebridge::world
