#include <algorithm>
#include <cmath>

#include "paths.hpp"
#include "world_impl.hpp"

namespace eyebridge::world {
namespace {

/// A point that is nearer than this, metres, is reached: what rounding leaves of a way.
constexpr double kArrived = 1e-9;

/// What the next step of a leg comes to, if nothing is in the way.
struct Stretch {
  double length = 0.0;  ///< Metres.
  double time = 0.0;    ///< Seconds.
  double speed = 0.0;   ///< At its end, metres per second.
  bool arrives = false;
};

Stretch even_stretch(const PathLeg& leg, double length, double dt) {
  if (length <= leg.speed * dt) return {length, length / leg.speed, leg.speed, true};
  return {leg.speed * dt, dt, leg.speed, false};
}

/// Of one that is `present` m/s fast, gains or loses `acceleration`, and ends no faster than the
/// leg allows.
Stretch ramped_stretch(const PathLeg& leg, double present, double acceleration, double length,
                       double dt) {
  const double mean_of_braking = 0.5 * (present + leg.end_speed);
  if (length <= mean_of_braking * dt + kArrived) {
    const double time = mean_of_braking > 0.0 ? std::min(dt, length / mean_of_braking) : 0.0;
    return {length, time, leg.end_speed, true};
  }
  const double change = acceleration * dt;
  double next = present + change;
  if (next > leg.speed) next = std::max(leg.speed, present - change);
  // v'^2 = end^2 + 2 a (length - (v + v') dt / 2): from v' on it can just brake.
  const double half = 0.5 * change;
  const double root =
      half * half + 2 * acceleration * length + leg.end_speed * leg.end_speed - change * present;
  const double braking = std::max(0.0, std::sqrt(std::max(0.0, root)) - half);
  next = std::min(next, braking);
  const double way = 0.5 * (present + next) * dt;
  return {std::min(way, length), dt, next, way >= length};
}

double value_or(const std::vector<double>& values, std::size_t i, double otherwise) {
  return i < values.size() ? values[i] : otherwise;
}

}  // namespace

std::vector<PathLeg> profile_of(const Path& path, const std::vector<Vec2>& stops) {
  if (path.leg_speeds.empty() && path.waits.empty() && path.acceleration == 0.0) return {};
  const std::size_t count = path.loop ? stops.size() : 2 * (stops.size() - 1);
  std::vector<PathLeg> legs(count);
  std::vector<double> lengths(count);
  std::vector<bool> stands(count);
  for (std::size_t i = 0; i < count; ++i) {
    const bool returns = !path.loop && i + 1 >= stops.size();
    const std::size_t end = returns ? count - 1 - i : (i + 1) % stops.size();
    const std::size_t leg = returns ? end : i;
    const std::size_t begin = returns ? end + 1 : i;
    lengths[i] = norm(stops[end] - stops[begin]);
    legs[i].speed = value_or(path.leg_speeds, leg, path.speed);
    legs[i].wait = value_or(path.waits, end == 0 ? stops.size() - 1 : end - 1, 0.0);
    stands[i] = legs[i].wait > 0.0 || (!path.loop && (end == 0 || end + 1 == stops.size()));
  }
  for (std::size_t i = 0; i < count; ++i) {
    legs[i].end_speed = stands[i] ? 0.0 : std::min(legs[i].speed, legs[(i + 1) % count].speed);
  }
  // Twice round, from the last leg: a short leg before a slow one is slow at its beginning, too.
  for (std::size_t k = 2 * count; k-- > 0;) {
    const std::size_t next = (k + 1) % count;
    const double end = legs[next].end_speed;
    const double fastest = std::sqrt(end * end + 2 * path.acceleration * lengths[next]);
    if (path.acceleration > 0.0) {
      legs[k % count].end_speed = std::min(legs[k % count].end_speed, fastest);
    }
  }
  return legs;
}

const PathLeg& Mover::leg() const {
  if (forward) return profile[(target + stops.size() - 1) % stops.size()];
  return profile[2 * stops.size() - 3 - target];
}

void World::Impl::follow_profile(Mover& mover, double dt) {
  double left = dt;
  for (std::size_t legs = 0; left > 0.0 && legs < 2 * mover.stops.size(); ++legs) {
    const double standing = std::min(mover.waits, left);
    mover.waits -= standing;
    left -= standing;
    if (left <= 0.0) return;
    const PathLeg& leg = mover.leg();
    const Vec2 way = mover.stops[mover.target] - bodies.position(mover.body);
    const double length = norm(way);
    const Stretch stretch =
        mover.acceleration > 0.0
            ? ramped_stretch(leg, mover.present, mover.acceleration, length, left)
            : even_stretch(leg, length, left);
    const Vec2 motion = stretch.arrives ? way : (stretch.length / length) * way;
    if (length > 0.0 && drive(mover.body, motion, dt).blocked()) {
      mover.present = 0.0;
      return;  // it tries again
    }
    mover.present = stretch.speed;
    if (!stretch.arrives) return;
    left -= stretch.time;
    mover.waits = leg.wait;
    if (leg.wait > 0.0) mover.present = 0.0;
    mover.turn_to_next();
  }
}

}  // namespace eyebridge::world
