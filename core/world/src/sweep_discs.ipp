// How the rays of a Sweep meet discs. Included by one source per instruction set; it has defined
// EYEBRIDGE_OF(name), what a member function of that name is called there, and what ray_lanes.ipp
// asks for.

#include "bearing_lanes.ipp"
#include "disc_lanes.ipp"

namespace {

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

/// The rays `first` to `last`, and maybe neighbours of theirs, and a disc at `w` from the origin,
/// which is not in it.
EYEBRIDGE_RAY_TARGET
inline void Sweep::EYEBRIDGE_OF(meet_run)(Vec2 w, double radius, std::size_t first,
                                          std::size_t last) {
  const SeenDisc disc{w.x, w.y, radius * radius};
  // Most discs are so far away that few rays go their way.
  meet_register(disc, dx + first, dy + first, best + first);
  for (std::size_t i = first + kLanes; i <= last; i += kLanes) {
    meet_register(disc, dx + i, dy + i, best + i);
  }
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

/// How far each ray and the kWindow - 1 next ones go, at most.
EYEBRIDGE_RAY_TARGET
inline void Sweep::EYEBRIDGE_OF(find_horizons)(float* horizons) const {
  // Ranges beyond the last ray are no more than 0; of what is not filled no ray's horizon is made.
  static_assert(kWindow + kLanes - 1 <= kBeyond && kFloats <= kBeyond);
  float ranges[kMost + 2 * kBeyond];
  for (std::size_t i = 0; i < count_ + kWindow; i += kLanes) {
    using Half = float __attribute__((vector_size(4 * kLanes)));
    Lanes range;
    load(range, best + i);
    const Half half = __builtin_convertvector(range, Half);
    std::memcpy(ranges + i, &half, sizeof half);
  }
  for (std::size_t i = 0; i < count_; i += kFloats) {
    Floats most = load(ranges + i);
    for (std::size_t k = 1; k < kWindow; ++k) most = larger(most, load(ranges + i + k));
    most *= 1.00001F;
    std::memcpy(horizons + i, &most, sizeof most);
  }
}

EYEBRIDGE_RAY_TARGET
void Sweep::EYEBRIDGE_OF(meet_discs)(const BodyMap& map, double largest_radius) {
  const BodyMap::Rows rows = map.rows();
  float horizons_of[kMost + kBeyond];
  EYEBRIDGE_OF(find_horizons)(horizons_of);
  const float* const horizons = horizons_of;
  const auto x0 = static_cast<float>(origin_.x);
  const auto y0 = static_cast<float>(origin_.y);
  const auto error = static_cast<float>(map.error(origin_));
  const Directions ahead = directions({dx[0], dy[0]}, turn_);
  const auto per_gap = static_cast<float>(per_gap_);
  const auto period = static_cast<float>(period_);
  const auto last = static_cast<float>(count_ - 1);
  const auto margin = static_cast<float>(kRoughError * per_gap_ + 2 * kRayMargin);
  // Of the rays next to where the numbers begin and end.
  const float rim = std::max(horizons[0], horizons[count_ > kWindow ? count_ - kWindow : 0]);

  // Which rays each disc may meet, where that is a run of them, and the ray's bearing, not upon the
  // disc.
  constexpr std::size_t kListed = 64;
  using List = Registers<kListed>;
  constexpr std::size_t kRoom = (sizeof(List::items) / sizeof(std::uint32_t) + 1) * kFloats;
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
    const Twice square = x * x + y * y;
    const Twice inverse = inverse_root_of(square);
    const Twice distance = square * inverse * (1.0F - kRoughError);
    const Twice number = rough_bearing_of(x, y, inverse, ahead) * per_gap;
    // As in meet_disc().
    const Twice sine = radius * inverse * (1.0F + kRoughError);
    const Twice width = (sine + 0.5708F * sine * sine * sine) * per_gap + margin;
    const Twice low = number - width;
    const Twice high = number + width;
    // The margin is more than a ray that lies at `low`.
    const Twice first = low + 1.0F;
    store(firsts + at, whole(first));
    store(lasts + at, whole(high));
    // Rays before the first one, and what is no number, as of no disc, must not lead out of the
    // table.
    const Twice here = smaller(larger(first, Twice{}), Twice{} + last);
    const Twice horizon = picked(horizons, whole(here));
    const Twice nearest = distance - radius;
    const TwiceBits wide = width > kWindow / 2.0F;
    const TwiceBits beside = (low > last) & (high < period);
    const TwiceBits inside = (low >= 0.0F) & (high <= last);
    const TwiceBits around = sine >= 0.99F;
    const TwiceBits plain = ((nearest <= horizon) | wide) & inside & ~around;
    return Seen{plain, around | (((nearest <= rim) | wide) & ~(inside | beside))};
  };
  const auto look_at_list = [&]() EYEBRIDGE_RAY_TARGET {
    LaneMarks<kListed> plain(list.size);
    LaneMarks<kListed> others(list.size);
    // Copies: what is written might be these, for all that the compiler knows.
    const auto look_here = look;
    const std::size_t size = list.size;
    for (std::size_t n = 0; n < size; n += 2) {
      const std::size_t other = n + 1 < size ? n + 1 : n;
      const Seen seen = look_here(list.items[n], list.items[other], n * kFloats);
      plain.bytes[n] = static_cast<std::uint8_t>(bits_of(seen.plain.one));
      plain.bytes[n + 1] = static_cast<std::uint8_t>(bits_of(seen.plain.other));
      others.bytes[n] = static_cast<std::uint8_t>(bits_of(seen.others.one));
      others.bytes[n + 1] = static_cast<std::uint8_t>(bits_of(seen.others.other));
    }
    if (size % 2 != 0) plain.bytes[size] = others.bytes[size] = 0;
    plain.each(list.size, [&](std::size_t n, std::size_t lane) EYEBRIDGE_RAY_TARGET {
      const Disc& disc = rows.discs[list.items[n] + lane];
      const std::size_t k = n * kFloats + lane;
      EYEBRIDGE_OF(meet_run)
      (Vec2{disc.x, disc.y} - origin_, disc.radius, static_cast<std::size_t>(firsts[k]),
       static_cast<std::size_t>(lasts[k]));
    });
    others.each(list.size, [&](std::size_t n, std::size_t lane) EYEBRIDGE_RAY_TARGET {
      EYEBRIDGE_OF(meet_disc)(rows.discs[list.items[n] + lane]);
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
