#include "fan.hpp"

#include <cassert>
#include <cmath>
#include <limits>

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

Fan::Fan(const RayFan& rays, std::uint32_t own_place)
    : origin(rays.origin),
      apart(!rays.origins.empty()),
      spread(apart ? rays.spread : 0.0),
      self(own_place),
      directions(rays.directions),
      origins(rays.origins),
      lines(rays.directions.size()) {
  assert(!directions.empty() && directions.size() <= kMost);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    dx[i] = directions[i].x;
    dy[i] = directions[i].y;
    x[i] = static_cast<float>(directions[i].x);
    y[i] = static_cast<float>(directions[i].y);
    best[i] = rays.max_range;
  }
  for (std::size_t i = directions.size(); i % 8 != 0; ++i) {
    dx[i] = dy[i] = 0.0;
    x[i] = y[i] = std::numeric_limits<float>::quiet_NaN();
    best[i] = rays.max_range;
  }
  if (apart) place();
  if (directions.size() % 2 == 0) {
    const std::size_t half = directions.size() / 2;
    double most = 0.0;
    for (std::size_t i = 0; i < half; ++i) {
      const Vec2 sum = directions[i] + directions[half + i];
      const double off = std::fabs(sum.x) + std::fabs(sum.y);
      most = off > most ? off : most;
    }
    if (most <= kOpposite && have_one_line_each(half)) lines = half;
  }
}

void Fan::place() {
  assert(origins.size() == directions.size());
  for (std::size_t i = 0; i < origins.size(); ++i) {
    assert(norm(origins[i] - origin) <= spread + kRounding);
    ox[i] = origins[i].x;
    oy[i] = origins[i].y;
    beside[i] = static_cast<float>(cross(origins[i] - origin, directions[i]));
  }
  for (std::size_t i = origins.size(); i % 8 != 0; ++i) {
    ox[i] = oy[i] = 0.0;
    beside[i] = 0.0F;
  }
}

bool Fan::have_one_line_each(std::size_t half) const {
  if (!apart) return true;
  for (std::size_t i = 0; i < half; ++i) {
    if (std::fabs(beside[i] + beside[half + i]) > kOneLine) return false;
  }
  return true;
}

}  // namespace eyebridge::world
