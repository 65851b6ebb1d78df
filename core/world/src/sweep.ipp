// How the rays of a Sweep meet walls and discs. Included by one source per instruction set; it has
// defined EYEBRIDGE_OF(name), what a member function of that name is called there, and what
// ray_lanes.ipp asks for.

#include "wall_lanes.ipp"

namespace {

/// Directions of ray 0 and, times the turn of the rays, of the same.
struct Directions {
  float x, turned_x, y, turned_y;
};

inline Directions directions(Vec2 first, double turn) {
  return {static_cast<float>(first.x), static_cast<float>(turn * first.x),
          static_cast<float>(first.y), static_cast<float>(turn * first.y)};
}

struct Bearing {
  Floats angle;     ///< From ray 0, in the direction in which rays are counted, 0 … 2 pi.
  Floats nearness;  ///< 1 by the distance, or up to sqrt(2) times as much.
};

/// Of places seen from the origin, within 1.2e-5 radians; see Sweep::number_of().
EYEBRIDGE_RAY_TARGET inline Bearing bearing_of(Floats px, Floats py, const Directions& ahead) {
  const Floats x = ahead.x * px + ahead.y * py;
  const Floats y = ahead.turned_x * py - ahead.turned_y * px;
  constexpr float kHalfTurn = 3.14159274F;
  const Floats ax = magnitude(x);
  const Floats ay = magnitude(y);
  const FloatBits steep = ax <= ay;
  const Floats nearness = 1.0F / larger(ax, ay);
  const Floats q = smaller(ax, ay) * nearness;
  const Floats s = q * q;
  Floats angle =
      q * (0.9998660F + s * (-0.3302995F + s * (0.1801410F + s * (-0.0851330F + s * 0.0208351F))));
  angle = steep ? kHalfTurn / 2 - angle : angle;
  angle = x < 0.0F ? kHalfTurn - angle : angle;
  return {y < 0.0F ? 2 * kHalfTurn - angle : angle, nearness};
}

/// The sector of the ray with that number.
EYEBRIDGE_RAY_TARGET inline FloatBits sector_of(Floats number) {
  return __builtin_convertvector(number * (1.0F / Sweep::kSector), FloatBits);
}

}  // namespace

EYEBRIDGE_RAY_TARGET
void Sweep::EYEBRIDGE_OF(meet_walls)(const Segment* segments, const WallList& walls) {
  const auto meet_rays = [this](const Segment& wall, std::size_t first, std::size_t last)
                             EYEBRIDGE_RAY_TARGET {
                               if (meet(wall, origin_, *this, first, last, true)) return;
                               for (std::size_t i = first; i <= last; ++i) {
                                 const Vec2 direction{dx[i], dy[i]};
                                 if (std::fabs(cross(direction, wall.u)) < kParallel) {
                                   best[i] = nearer_hit(wall, origin_, direction, best[i]);
                                 }
                               }
                             };
  const auto error = static_cast<float>(walls.error);
  const auto turn = static_cast<float>(turn_);
  const auto period = static_cast<float>(period_);
  const auto per_gap = static_cast<float>(per_gap_);
  const auto margin = static_cast<float>(2 * kBearingError * per_gap_ + 2 * kRayMargin);
  const Directions ahead = directions({dx[0], dy[0]}, turn_);
  float from[kFloats];
  float to[kFloats];
  for (std::size_t k = 0; k < walls.indices.size(); k += kFloats) {
    const Ends ends = ends_of(walls, k, origin_);
    const Bearing a = bearing_of(ends.ax, ends.ay, ahead);
    const Bearing b = bearing_of(ends.bx, ends.by, ahead);
    const FloatBits forward = turn * ends.area > 0.0F;
    const Floats low = (forward ? a.angle : b.angle) * per_gap;
    const Floats next = (forward ? b.angle : a.angle) * per_gap;
    const Floats high = next < low ? next + period : next;
    // By how much ends that are so far off may seem to be elsewhere.
    const Floats nearness = larger(a.nearness, b.nearness);
    const Floats off = margin + 1.2F * error * nearness * per_gap;
    const FloatBits all = ends.along | (error * nearness >= 0.3F);
    const Floats first = all ? Floats{} : low - off;
    const Floats last = all ? Floats{} + period : high + off;
    std::memcpy(from, &first, sizeof first);
    std::memcpy(to, &last, sizeof last);
    const std::size_t rest = walls.indices.size() - k;
    for (std::size_t i = 0; i < (rest < kFloats ? rest : kFloats); ++i) {
      const Segment& wall = segments[walls.indices[k + i]];
      each_between(from[i], to[i],
                   [&](std::size_t first_ray, std::size_t last_ray)
                       EYEBRIDGE_RAY_TARGET { meet_rays(wall, first_ray, last_ray); });
    }
  }
}

/// The rays `first` to `last`, and maybe neighbours of theirs, and a disc at `w` from the origin,
/// which is not in it: nearer_disc_hit() of each.
EYEBRIDGE_RAY_TARGET
inline void Sweep::EYEBRIDGE_OF(meet_run)(Vec2 w, double radius, std::size_t first,
                                          std::size_t last) {
  const double radius_squared = radius * radius;
  const auto meet_four = [&](std::size_t i) EYEBRIDGE_RAY_TARGET {
    Lanes x;
    Lanes y;
    Lanes nearest;
    load(x, dx + i);
    load(y, dy + i);
    load(nearest, best + i);
    const Lanes along = w.x * x + w.y * y;
    const Lanes across = x * w.y - y * w.x;
    const Lanes half_chord_squared = radius_squared - across * across;
    const LaneBits hit = (along > 0.0) & (half_chord_squared >= 0.0);
    const Lanes range = along - root_of(half_chord_squared);
    nearest = (hit & (range < nearest)) ? range : nearest;
    std::memcpy(best + i, &nearest, sizeof nearest);
  };
  // Two registers, whether there are or not: nobody can foresee how many there are.
  std::size_t i = first / kLanes * kLanes;
  meet_four(i);
  meet_four(i + kLanes);
  for (i += 2 * kLanes; i <= last; i += kLanes) meet_four(i);
}

EYEBRIDGE_RAY_TARGET
void Sweep::EYEBRIDGE_OF(meet_disc)(const Disc& disc, double ray, double half_width) {
  const Vec2 w = Vec2{disc.x, disc.y} - origin_;
  if (norm_squared(w) - disc.radius * disc.radius <= 0.0) [[unlikely]] {
    for (std::size_t i = 0; i < count_; ++i) best[i] = best[i] > 0.0 ? 0.0 : best[i];
    return;
  }
  const double from = ray - half_width;
  const double to = ray + half_width;
  if (from >= 0.0 && to < static_cast<double>(count_)) [[likely]] {
    const auto first = static_cast<std::size_t>(from);
    EYEBRIDGE_OF(meet_run)(w, disc.radius, first, static_cast<std::size_t>(to));
    return;
  }
  each_between(from, to, [&](std::size_t first, std::size_t last) EYEBRIDGE_RAY_TARGET {
    EYEBRIDGE_OF(meet_run)(w, disc.radius, first, last);
  });
}

EYEBRIDGE_RAY_TARGET
void Sweep::EYEBRIDGE_OF(meet_discs)(std::span<const Disc> discs, BodyId ignore) {
  for (const Disc& disc : discs) {
    if (disc.id == ignore) continue;
    const Vec2 w = Vec2{disc.x, disc.y} - origin_;
    // asin(s) <= s + (pi / 2 - 1) s^3: all terms of its series are positive, and equal at 1.
    const double sine = std::min(disc.radius / norm(w), 1.0);
    const double angle = sine + 0.5708 * sine * sine * sine + kBearingError;
    EYEBRIDGE_OF(meet_disc)(disc, number_of(w), angle * per_gap_ + kRayMargin);
  }
}

/// How far the rays of each sector go, at most.
EYEBRIDGE_RAY_TARGET
inline void Sweep::EYEBRIDGE_OF(find_horizons)(float* horizons) const {
  for (std::size_t ray = 0; ray < count_; ray += kSector) {
    Lanes most{};
    for (std::size_t i = 0; i < kSector; i += kLanes) {
      Lanes range;
      load(range, best + ray + i);
      most = range > most ? range : most;
    }
    double farthest = most[0];
    for (std::size_t i = 1; i < kLanes; ++i) farthest = most[i] > farthest ? most[i] : farthest;
    *horizons++ = static_cast<float>(farthest) * 1.00001F;
  }
}

EYEBRIDGE_RAY_TARGET
void Sweep::EYEBRIDGE_OF(meet_discs)(const BodyMap& map, double reach) {
  const BodyMap::Rows rows = map.rows(origin_);
  float horizons[kMost / kSector];
  EYEBRIDGE_OF(find_horizons)(horizons);
  const auto x0 = static_cast<float>(origin_.x);
  const auto y0 = static_cast<float>(origin_.y);
  const auto error = static_cast<float>(rows.error);
  const Directions ahead = directions({dx[0], dy[0]}, turn_);
  const auto per_gap = static_cast<float>(per_gap_);
  const auto period = static_cast<float>(period_);
  const auto last = static_cast<float>(count_ - 1);
  const auto margin = static_cast<float>(2 * kBearingError * per_gap_ + 2 * kRayMargin);

  // The number of the ray that points to each disc, and how many more it may meet to either side.
  float numbers[8 * kFloats];
  float widths[8 * kFloats];
  const auto look = [&](std::size_t from, std::size_t at) EYEBRIDGE_RAY_TARGET {
    const Floats x = load(rows.x + from) - x0;
    const Floats y = load(rows.y + from) - y0;
    const Floats radius = load(rows.radius + from) + error;
    const Floats distance = root_of(x * x + y * y);
    const Floats number = bearing_of(x, y, ahead).angle * per_gap;
    // asin(s) <= s + (pi / 2 - 1) s^3: all terms of its series are positive, and equal at 1.
    const Floats sine = radius / distance;
    const FloatBits round = sine >= 0.99F;
    const Floats width =
        round ? Floats{} + period : (sine + 0.5708F * sine * sine * sine) * per_gap + margin;
    std::memcpy(numbers + at, &number, sizeof number);
    std::memcpy(widths + at, &width, sizeof width);
    const Floats low = number - width;
    const Floats high = number + width;
    // Rays that few lie in two sectors at most. Those at the ends, and what is no number, as of no
    // disc, must not lead out of the table.
    const Floats here = larger(low, Floats{});
    const Floats there = smaller(high, Floats{} + last);
    const Floats horizon = larger(picked(horizons, sector_of(smaller(here, Floats{} + last))),
                                  picked(horizons, sector_of(larger(there, Floats{}))));
    const FloatBits seen =
        (distance - radius <= horizon) | (width > kSector / 2.0F) | (low < 0.0F) | (high > last);
    const FloatBits beside = (low > last) & (high < period);
    return bits_of(seen & ~beside & (radius >= 0.0F));
  };
  const BodyMap::Box box = map.box(origin_ - Vec2{reach, reach}, origin_ + Vec2{reach, reach});
  for (std::size_t row = box.first_row; row <= box.last_row; ++row) {
    const std::size_t end = map.end_of(box, row);
    for (std::size_t begin = map.begin_of(box, row); begin < end; begin += 8 * kFloats) {
      const std::size_t count = std::min(end - begin, 8 * kFloats);
      std::uint64_t seen = 0;
      for (std::size_t k = 0; k < count; k += kFloats) {
        seen |= std::uint64_t{look(begin + k, k)} << (k / kFloats * 8);
      }
      for (; seen != 0; seen &= seen - 1) {
        const auto bit = static_cast<std::size_t>(__builtin_ctzll(seen));
        const std::size_t k = bit / 8 * kFloats + bit % 8;
        EYEBRIDGE_OF(meet_disc)(rows.discs[begin + k], numbers[k], widths[k]);
      }
    }
  }
}
