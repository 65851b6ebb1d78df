// How the rays of a Sweep meet walls and discs. Included by one source per instruction set; it has
// defined EYEBRIDGE_OF(name), what a member function of that name is called there, and what
// ray_lanes.ipp asks for.

#include "disc_lanes.ipp"
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
  // Most discs are so far away that few rays go their way.
  for (std::size_t i = first; i <= last; i += kLanes) meet_four(i);
}

EYEBRIDGE_RAY_TARGET
void Sweep::EYEBRIDGE_OF(meet_disc)(const Disc& disc) {
  const Vec2 w = Vec2{disc.x, disc.y} - origin_;
  if (norm_squared(w) - disc.radius * disc.radius <= 0.0) {
    for (std::size_t i = 0; i < count_; ++i) best[i] = best[i] > 0.0 ? 0.0 : best[i];
    return;
  }
  // asin(s) <= s + (pi / 2 - 1) s^3: all terms of its series are positive, and equal at 1.
  const double sine = std::min(disc.radius / norm(w), 1.0);
  const double angle = sine + 0.5708 * sine * sine * sine + kBearingError;
  const double number = number_of(w);
  const double half_width = angle * per_gap_ + kRayMargin;
  each_between(number - half_width, number + half_width,
               [&](std::size_t first, std::size_t last) EYEBRIDGE_RAY_TARGET {
                 EYEBRIDGE_OF(meet_run)(w, disc.radius, first, last);
               });
}

EYEBRIDGE_RAY_TARGET
void Sweep::EYEBRIDGE_OF(meet_discs)(std::span<const Disc> discs, BodyId ignore) {
  for (const Disc& disc : discs) {
    if (disc.id != ignore) EYEBRIDGE_OF(meet_disc)(disc);
  }
}

/// How far the rays of each sector and the next one go, at most.
EYEBRIDGE_RAY_TARGET
inline void Sweep::EYEBRIDGE_OF(find_horizons)(float* horizons) const {
  float before = 0.0F;
  for (std::size_t ray = 0; ray < count_; ray += kSector) {
    Lanes most{};
    for (std::size_t i = 0; i < kSector; i += kLanes) {
      Lanes range;
      load(range, best + ray + i);
      most = range > most ? range : most;
    }
    double farthest = most[0];
    for (std::size_t i = 1; i < kLanes; ++i) farthest = most[i] > farthest ? most[i] : farthest;
    const float here = static_cast<float>(farthest) * 1.00001F;
    *horizons++ = here > before ? here : before;
    before = here;
  }
  *horizons = before;
}

EYEBRIDGE_RAY_TARGET
void Sweep::EYEBRIDGE_OF(meet_discs)(const BodyMap& map, double largest_radius) {
  const BodyMap::Rows rows = map.rows(origin_);
  float horizons_of[kMost / kSector + 1];
  EYEBRIDGE_OF(find_horizons)(horizons_of);
  const float* const horizons = horizons_of + 1;
  const auto x0 = static_cast<float>(origin_.x);
  const auto y0 = static_cast<float>(origin_.y);
  const auto error = static_cast<float>(rows.error);
  const Directions ahead = directions({dx[0], dy[0]}, turn_);
  const auto per_gap = static_cast<float>(per_gap_);
  const auto period = static_cast<float>(period_);
  const auto last = static_cast<float>(count_ - 1);
  const auto margin = static_cast<float>(2 * kBearingError * per_gap_ + 2 * kRayMargin);

  // Which rays each disc may meet, where that is a run of them, and the ray's bearing, not upon the
  // disc.
  std::int32_t firsts[(kMostStarts + kUsualStarts) * kFloats];
  std::int32_t lasts[(kMostStarts + kUsualStarts) * kFloats];
  struct Seen {
    unsigned plain, others;
  };
  const auto look = [&](std::size_t from, std::size_t at) EYEBRIDGE_RAY_TARGET {
    const Floats x = load(rows.x + from) - x0;
    const Floats y = load(rows.y + from) - y0;
    const Floats radius = load(rows.radius + from) + error;
    const Floats distance = root_of(x * x + y * y);
    const Floats number = bearing_of(x, y, ahead).angle * per_gap;
    // As in meet_disc().
    const Floats sine = radius / distance;
    const Floats width = (sine + 0.5708F * sine * sine * sine) * per_gap + margin;
    const Floats low = number - width;
    const Floats high = number + width;
    const FloatBits first = __builtin_convertvector(low, FloatBits);
    const FloatBits until = __builtin_convertvector(high, FloatBits);
    std::memcpy(firsts + at, &first, sizeof first);
    std::memcpy(lasts + at, &until, sizeof until);
    // Rays that few lie in two sectors at most. Those before the first one, and what is no number,
    // as of no disc, must not lead out of the table.
    const Floats here = smaller(larger(low, Floats{}), Floats{} + last);
    const Floats horizon = picked(horizons, sector_of(here));
    const FloatBits seen = (distance - radius <= horizon) | (width > kSector / 2.0F);
    const FloatBits beside = (low > last) & (high < period);
    const FloatBits around = sine >= 0.99F;
    const FloatBits other = around | (((low < 0.0F) | (high > last)) & ~beside);
    return Seen{bits_of(seen & ~(other | beside)), bits_of(other)};
  };
  each_register(
      map, rows,
      [&]() EYEBRIDGE_RAY_TARGET {
        return extent_of(origin_, dx, dy, best, count_, largest_radius + kExtentMargin);
      },
      [&](const std::uint32_t* starts, std::size_t size) EYEBRIDGE_RAY_TARGET {
        LaneMarks plain(size);
        LaneMarks others(size);
        for (std::size_t n = 0; n < size; ++n) {
          const Seen seen = look(starts[n], n * kFloats);
          plain.bytes[n] = static_cast<std::uint8_t>(seen.plain);
          others.bytes[n] = static_cast<std::uint8_t>(seen.others);
        }
        plain.each(size, [&](std::size_t n, std::size_t lane) EYEBRIDGE_RAY_TARGET {
          const Disc& disc = rows.discs[starts[n] + lane];
          const std::size_t k = n * kFloats + lane;
          EYEBRIDGE_OF(meet_run)
          (Vec2{disc.x, disc.y} - origin_, disc.radius, static_cast<std::size_t>(firsts[k]),
           static_cast<std::size_t>(lasts[k]));
        });
        others.each(size, [&](std::size_t n, std::size_t lane) EYEBRIDGE_RAY_TARGET {
          EYEBRIDGE_OF(meet_disc)(rows.discs[starts[n] + lane]);
        });
      });
}
