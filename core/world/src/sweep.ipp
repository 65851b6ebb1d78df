// How the rays of a Sweep meet walls and discs. Included by one source per instruction set; it has
// defined EYEBRIDGE_OF(name), what a member function of that name is called there, and what
// ray_lanes.ipp asks for.

#include "disc_lanes.ipp"
#include "twice.ipp"
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

template <class Values>
struct Bearing {
  Values angle;     ///< From ray 0, in the direction in which rays are counted, 0 … 2 pi.
  Values nearness;  ///< 1 by the distance, or up to sqrt(2) times as much.
};

/// Of places seen from the origin, within 1.2e-5 radians; see Sweep::number_of().
template <class Values>
EYEBRIDGE_RAY_TARGET inline Bearing<Values> bearing_of(Values px, Values py,
                                                       const Directions& ahead) {
  const Values x = ahead.x * px + ahead.y * py;
  const Values y = ahead.turned_x * py - ahead.turned_y * px;
  constexpr float kHalfTurn = 3.14159274F;
  const Values ax = magnitude(x);
  const Values ay = magnitude(y);
  const Values nearness = 1.0F / larger(ax, ay);
  const Values q = smaller(ax, ay) * nearness;
  const Values s = q * q;
  Values angle =
      q * (0.9998660F + s * (-0.3302995F + s * (0.1801410F + s * (-0.0851330F + s * 0.0208351F))));
  angle = either(ax <= ay, kHalfTurn / 2 - angle, angle);
  angle = either(x < 0.0F, kHalfTurn - angle, angle);
  return {either(y < 0.0F, 2 * kHalfTurn - angle, angle), nearness};
}

/// The sector of the ray with that number.
template <class Values>
EYEBRIDGE_RAY_TARGET inline auto sector_of(Values number) {
  return whole(number * (1.0F / Sweep::kSector));
}

/// A byte for each register of a list of `kMost`: bits of lanes.
template <std::size_t kMost>
struct LaneMarks {
  static constexpr std::size_t kWord = sizeof(std::uint64_t);

  explicit LaneMarks(std::size_t size) { std::memset(bytes + size / kWord * kWord, 0, kWord); }

  /// Calls visit(n, lane) for each lane that is set in the first `size` registers.
  template <class Visit>
  EYEBRIDGE_RAY_TARGET void each(std::size_t size, Visit visit) const {
    for (std::size_t n = 0; n < size; n += kWord) {
      std::uint64_t word;
      std::memcpy(&word, bytes + n, kWord);
      for (; word != 0; word &= word - 1) {
        const auto bit = static_cast<std::size_t>(__builtin_ctzll(word));
        visit(n + bit / 8, bit % 8);
      }
    }
  }

  std::uint8_t bytes[kMost + kUsualStarts + kWord];
};

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
    const Bearing<Floats> a = bearing_of(ends.ax, ends.ay, ahead);
    const Bearing<Floats> b = bearing_of(ends.bx, ends.by, ahead);
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
  const Lanes never = Lanes{} + std::numeric_limits<double>::infinity();
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
    const Lanes range = hit ? along - root_of(half_chord_squared) : never;
    nearest = smaller(range, nearest);
    std::memcpy(best + i, &nearest, sizeof nearest);
  };
  // Most discs are so far away that few rays go their way.
  meet_four(first);
  for (std::size_t i = first + kLanes; i <= last; i += kLanes) meet_four(i);
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
  const BodyMap::Rows rows = map.rows();
  float horizons_of[kMost / kSector + 1];
  EYEBRIDGE_OF(find_horizons)(horizons_of);
  const float* const horizons = horizons_of + 1;
  const auto x0 = static_cast<float>(origin_.x);
  const auto y0 = static_cast<float>(origin_.y);
  const auto error = static_cast<float>(map.error(origin_));
  const Directions ahead = directions({dx[0], dy[0]}, turn_);
  const auto per_gap = static_cast<float>(per_gap_);
  const auto period = static_cast<float>(period_);
  const auto last = static_cast<float>(count_ - 1);
  const auto margin = static_cast<float>(2 * kBearingError * per_gap_ + 2 * kRayMargin);

  // Which rays each disc may meet, where that is a run of them, and the ray's bearing, not upon the
  // disc.
  constexpr std::size_t kListed = 64;
  using List = Registers<kListed>;
  constexpr std::size_t kRoom = (sizeof(List::starts) / sizeof(std::uint32_t) + 1) * kFloats;
  List list;
  std::int32_t firsts_of[kRoom];
  std::int32_t lasts_of[kRoom];
  std::int32_t* const firsts = firsts_of;
  std::int32_t* const lasts = lasts_of;
  struct Seen {
    TwiceBits plain, others;
  };
  const auto look = [=](std::size_t one, std::size_t other, std::size_t at) EYEBRIDGE_RAY_TARGET {
    const Twice x = load_twice(rows.x, one, other) - x0;
    const Twice y = load_twice(rows.y, one, other) - y0;
    const Twice radius = load_twice(rows.radius, one, other) + error;
    const Twice distance = root_of(x * x + y * y);
    const Twice number = bearing_of(x, y, ahead).angle * per_gap;
    // As in meet_disc().
    const Twice sine = radius / distance;
    const Twice width = (sine + 0.5708F * sine * sine * sine) * per_gap + margin;
    const Twice low = number - width;
    const Twice high = number + width;
    store(firsts + at, whole(low));
    store(lasts + at, whole(high));
    // Rays that few lie in two sectors at most. Those before the first one, and what is no number,
    // as of no disc, must not lead out of the table.
    const Twice here = smaller(larger(low, Twice{}), Twice{} + last);
    const Twice horizon = picked(horizons, sector_of(here));
    const TwiceBits seen = (distance - radius <= horizon) | (width > kSector / 2.0F);
    const TwiceBits beside = (low > last) & (high < period);
    const TwiceBits around = sine >= 0.99F;
    const TwiceBits elsewhere = around | (((low < 0.0F) | (high > last)) & ~beside);
    return Seen{seen & ~(elsewhere | beside), elsewhere};
  };
  const auto look_at_list = [&]() EYEBRIDGE_RAY_TARGET {
    LaneMarks<kListed> plain(list.size);
    LaneMarks<kListed> others(list.size);
    // Copies: what is written might be these, for all that the compiler knows.
    const auto look_here = look;
    const std::size_t size = list.size;
    for (std::size_t n = 0; n < size; n += 2) {
      const std::size_t other = n + 1 < size ? n + 1 : n;
      const Seen seen = look_here(list.starts[n], list.starts[other], n * kFloats);
      plain.bytes[n] = static_cast<std::uint8_t>(bits_of(seen.plain.one));
      plain.bytes[n + 1] = static_cast<std::uint8_t>(bits_of(seen.plain.other));
      others.bytes[n] = static_cast<std::uint8_t>(bits_of(seen.others.one));
      others.bytes[n + 1] = static_cast<std::uint8_t>(bits_of(seen.others.other));
    }
    if (size % 2 != 0) plain.bytes[size] = others.bytes[size] = 0;
    plain.each(list.size, [&](std::size_t n, std::size_t lane) EYEBRIDGE_RAY_TARGET {
      const Disc& disc = rows.discs[list.starts[n] + lane];
      const std::size_t k = n * kFloats + lane;
      EYEBRIDGE_OF(meet_run)
      (Vec2{disc.x, disc.y} - origin_, disc.radius, static_cast<std::size_t>(firsts[k]),
       static_cast<std::size_t>(lasts[k]));
    });
    others.each(list.size, [&](std::size_t n, std::size_t lane) EYEBRIDGE_RAY_TARGET {
      EYEBRIDGE_OF(meet_disc)(rows.discs[list.starts[n] + lane]);
    });
    list.size = 0;
  };
  list.add(
      map, rows.nobody, origin_,
      [&]() EYEBRIDGE_RAY_TARGET {
        return reaches_of(dx, dy, best, count_, largest_radius + kExtentMargin);
      },
      look_at_list);
  look_at_list();
}
