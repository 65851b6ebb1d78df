// How the rays of a Fan meet discs. Included by one source per instruction set; it has defined
// EYEBRIDGE_OF(name), what a member function of that name is called there, and what ray_lanes.ipp
// asks for.

#include "disc_lanes.ipp"

namespace {

/// For eight bits, the numbers of those that are set, in order.
struct LaneTable {
  std::uint8_t numbers[256][8];
};
constexpr LaneTable make_lane_table() {
  LaneTable table{};
  for (unsigned bits = 0; bits < 256; ++bits) {
    std::size_t count = 0;
    for (unsigned lane = 0; lane < 8; ++lane) {
      if ((bits >> lane & 1U) != 0) table.numbers[bits][count++] = static_cast<std::uint8_t>(lane);
    }
  }
  return table;
}
constexpr LaneTable kLaneTable = make_lane_table();

/// Writes `first` + the numbers of the lanes that `bits` has, in order, to `at`, where kFloats fit,
/// and returns the place after them. No branch: nobody can foresee how many there are.
EYEBRIDGE_RAY_TARGET inline std::uint32_t* list_lanes(unsigned bits, std::uint32_t first,
                                                      std::uint32_t* at) {
  const std::uint8_t* const numbers = kLaneTable.numbers[bits];
#if defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 4
  using Numbers = std::uint32_t __attribute__((vector_size(4 * kFloats)));
  const auto lanes =
      (Numbers)_mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(numbers)));
  const Numbers all = lanes + first;
  std::memcpy(at, &all, sizeof all);
#else
  for (std::size_t i = 0; i < kFloats; ++i) at[i] = first + numbers[i];
#endif
  return at + __builtin_popcount(bits);
}

/// What is found out about discs and several fans, step by step.
struct Looks {
  using List = Registers<256>;
  static constexpr unsigned kDiscBits = 28;
  static_assert(kFansTogether <= std::size_t{1} << (32U - kDiscBits));
  static constexpr std::uint32_t kDisc = (std::uint32_t{1} << kDiscBits) - 1;

  List list;
  std::uint32_t ends[kFansTogether];  ///< Fan -> where its registers in `list` end.
  /// Fan and disc, where that is near one of its lines.
  std::uint32_t pairs[(sizeof list.items / sizeof *list.items + 1) * kFloats];
};

}  // namespace

/// Lists the discs of the registers of `rows` that begin at `starts` that are near a line, each +
/// `code`, at `pairs`; returns the end. The floats may be `off` by so many metres.
EYEBRIDGE_RAY_TARGET __attribute__((always_inline)) inline std::uint32_t* Fan::EYEBRIDGE_OF(look)(
    const BodyMap::Rows& rows, double off, std::span<const std::uint32_t> starts,
    std::uint32_t code, std::uint32_t* pairs) const {
  const Floats x0 = filled(static_cast<float>(origin_.x));
  const Floats y0 = filled(static_cast<float>(origin_.y));
  const Floats error = filled(static_cast<float>(off));
  const Floats line_x[] = {filled(x_[0]), filled(x_[1]), filled(x_[2]), filled(x_[3])};
  const Floats line_y[] = {filled(y_[0]), filled(y_[1]), filled(y_[2]), filled(y_[3])};
  // Copies: what is written might be these, for all that the compiler knows.
  const float* const xs = rows.x;
  const float* const ys = rows.y;
  const float* const radii = rows.radius;
  const std::size_t lines = lines_;
  const std::uint32_t self = self_;
  Floats beside[4]{};
  if (apart_) {
    for (std::size_t i = 0; i < 4; ++i) beside[i] = filled(beside_[i]);
  }
  // A loop through no more lines costs a tenth of all that a fan does.
  const auto list = [&](auto has_more, auto apart) EYEBRIDGE_RAY_TARGET {
    for (const std::uint32_t start : starts) {
      const Floats x = x0 - load(xs + start);
      const Floats y = y0 - load(ys + start);
      const auto to_line = [&](std::size_t i) EYEBRIDGE_RAY_TARGET {
        const Floats across = x * line_y[i] - y * line_x[i];
        if constexpr (apart) {
          return magnitude(across + beside[i]);
        } else {
          return magnitude(across);
        }
      };
      // What is no number, as there is no such line, comes first, and the other one is smaller.
      Floats across = smaller(smaller(to_line(3), to_line(2)), smaller(to_line(1), to_line(0)));
      if constexpr (has_more) {
        for (std::size_t i = 4; i < lines; ++i) {
          const float shift = apart ? beside_[i] : 0.0F;
          across = smaller(magnitude(x * y_[i] - y * x_[i] + shift), across);
        }
      }
      const std::uint32_t mine = self - start;
      const unsigned own = (mine < kFloats ? 1U : 0U) << mine % kFloats;
      const unsigned near = bits_of(across <= load(radii + start) + error) & ~own;
      pairs = list_lanes(near, code + start, pairs);
    }
  };
  const auto list_by_lines = [&](auto apart) EYEBRIDGE_RAY_TARGET {
    if (lines <= 4) [[likely]] {
      list(std::false_type{}, apart);
    } else {
      list(std::true_type{}, apart);
    }
  };
  if (apart_) {
    list_by_lines(std::true_type{});
  } else {
    list_by_lines(std::false_type{});
  }
  return pairs;
}

EYEBRIDGE_RAY_TARGET
void Fan::EYEBRIDGE_OF(meet_discs)(std::span<Fan> fans, const BodyMap& map, double largest_radius) {
  Looks looks;
  const BodyMap::Rows rows = map.rows();
  assert(rows.nobody <= Looks::kDisc);
  std::size_t first = 0;  // of those that are in the list
  // Loops through all fans at once are long: where one ends nobody can foresee.
  const auto look_at_list = [&](std::size_t last) EYEBRIDGE_RAY_TARGET {
    looks.ends[last] = static_cast<std::uint32_t>(looks.list.size);
    std::uint32_t* end = looks.pairs;
    std::size_t begin = 0;
    for (std::size_t f = first; f <= last; ++f) {
      const auto code = static_cast<std::uint32_t>(f << Looks::kDiscBits);
      end =
          fans[f].EYEBRIDGE_OF(look)(rows, map.error(fans[f].origin_),
                                     {looks.list.items + begin, looks.ends[f] - begin}, code, end);
      begin = looks.ends[f];
    }
    for (const std::uint32_t* pair = looks.pairs; pair != end; ++pair) {
      Fan& fan = fans[*pair >> Looks::kDiscBits];
      const Disc& disc = rows.discs[*pair & Looks::kDisc];
      if (fan.apart_) {
        fan.EYEBRIDGE_OF(meet_apart)(disc);
      } else {
        fan.EYEBRIDGE_OF(meet)(disc);
      }
    }
    looks.list.size = 0;
    first = last;
  };
  for (std::size_t f = 0; f < fans.size(); ++f) {
    const Fan& fan = fans[f];
    looks.list.add(
        map, rows.nobody, fan.origin_,
        [&]() EYEBRIDGE_RAY_TARGET {
          return reaches_of(fan.dx_, fan.dy_, fan.best_, fan.directions_.size(),
                            largest_radius + fan.spread_ + kExtentMargin);
        },
        [&]() EYEBRIDGE_RAY_TARGET { look_at_list(f); });
    looks.ends[f] = static_cast<std::uint32_t>(looks.list.size);
  }
  look_at_list(fans.size() - 1);
}

/// nearer_disc_hit() of all rays: the same operations on the same numbers.
EYEBRIDGE_RAY_TARGET __attribute__((always_inline)) inline void Fan::EYEBRIDGE_OF(meet)(
    const Disc& disc) {
  const double wx = disc.x - origin_.x;
  const double wy = disc.y - origin_.y;
  const double radius_squared = disc.radius * disc.radius;
  const std::size_t count = directions_.size();
  if (wx * wx + wy * wy - radius_squared <= 0.0) [[unlikely]] {
    for (std::size_t i = 0; i < count; ++i) best_[i] = best_[i] > 0.0 ? 0.0 : best_[i];
    return;
  }
  const SeenDisc seen_disc{wx, wy, radius_squared};
  for (std::size_t i = 0; i < count; i += kLanes) {
    meet_register(seen_disc, dx_ + i, dy_ + i, best_ + i);
  }
}

/// The same for rays that begin at places of their own.
EYEBRIDGE_RAY_TARGET void Fan::EYEBRIDGE_OF(meet_apart)(const Disc& disc) {
  const double radius_squared = disc.radius * disc.radius;
  for (std::size_t i = 0; i < directions_.size(); i += kLanes) {
    Lanes dx;
    Lanes dy;
    Lanes wx;
    Lanes wy;
    Lanes best;
    load(dx, dx_ + i);
    load(dy, dy_ + i);
    load(wx, ox_ + i);
    load(wy, oy_ + i);
    load(best, best_ + i);
    wx = disc.x - wx;
    wy = disc.y - wy;
    const LaneBits inside = wx * wx + wy * wy - radius_squared <= 0.0;
    const Lanes range = range_to_disc(wx, wy, radius_squared, dx, dy);
    best = smaller(inside ? Lanes{} : range, best);
    std::memcpy(best_ + i, &best, sizeof best);
  }
}
