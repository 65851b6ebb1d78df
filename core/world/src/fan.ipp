// How the rays of a Fan meet walls and discs. Included by one source per instruction set; it has
// defined EYEBRIDGE_OF(name), what a member function of that name is called there, and what
// ray_lanes.ipp asks for.

#include "disc_lanes.ipp"
#include "wall_lanes.ipp"

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

/// `value` in each lane.
EYEBRIDGE_RAY_TARGET inline Floats filled(float value) { return value - Floats{}; }

EYEBRIDGE_RAY_TARGET inline FloatBits sign_of(Floats v) {
  return (FloatBits)v & std::numeric_limits<std::int32_t>::min();
}
EYEBRIDGE_RAY_TARGET inline Floats turned(Floats v, FloatBits sign) {
  return (Floats)((FloatBits)v ^ sign);
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
  std::uint32_t pairs[(sizeof list.starts / sizeof *list.starts + 1) * kFloats];
};

}  // namespace

/// A word of Pairs: which lanes of meets(ray) are set.
template <class Meets>
EYEBRIDGE_RAY_TARGET inline std::uint64_t Fan::EYEBRIDGE_OF(word)(std::size_t octet,
                                                                  Meets meets) const {
  const std::size_t first = octet * Pairs::kRays;
  const auto bits = [&](std::size_t i) EYEBRIDGE_RAY_TARGET {
    return std::uint64_t{bits_of(meets(first + i))} << (i * Pairs::kLanes);
  };
  const std::uint64_t word = bits(0) | bits(1) | bits(2) | bits(3);
  if (first + 4 >= directions_.size()) return word;
  return word | bits(4) | bits(5) | bits(6) | bits(7);
}

EYEBRIDGE_RAY_TARGET
void Fan::EYEBRIDGE_OF(meet_walls)(const Segment* segments, const WallList& walls) {
  const std::size_t count = directions_.size();
  const auto error = static_cast<float>(walls.error);
  const bool both_ways = 2 * lines_ == count && lines_ <= 4;
  Pairs pairs;
  for (std::size_t k = 0; k < walls.indices.size(); k += kFloats) {
    const Ends ends = ends_of(walls, k, origin_);
    // Turned so that b is to the left of a.
    const FloatBits sign = sign_of(ends.area);
    const Floats ax = turned(ends.ax, sign);
    const Floats ay = turned(ends.ay, sign);
    const Floats bx = turned(ends.bx, sign);
    const Floats by = turned(ends.by, sign);
    const auto left_of_a = [&](std::size_t ray)
                               EYEBRIDGE_RAY_TARGET { return ax * y_[ray] - ay * x_[ray]; };
    const auto left_of_b = [&](std::size_t ray)
                               EYEBRIDGE_RAY_TARGET { return bx * y_[ray] - by * x_[ray]; };
    for (std::size_t octet = 0; octet * Pairs::kRays < count; ++octet) {
      std::uint64_t word = 0;
      if (both_ways) {
        // Rays that look the other way have both ends on the other sides.
        std::uint64_t back = 0;
        for (std::size_t i = 0; i < 4; ++i) {
          const Floats a = left_of_a(i);
          const Floats b = left_of_b(i);
          word |= std::uint64_t{bits_of((a >= -error) & (b <= error))} << (i * Pairs::kLanes);
          back |= std::uint64_t{bits_of((a <= error) & (b >= -error))} << (i * Pairs::kLanes);
        }
        // There may be fewer lines than four.
        word &= (std::uint64_t{1} << (lines_ * Pairs::kLanes)) - 1;
        word |= back << (lines_ * Pairs::kLanes);
      } else {
        word = EYEBRIDGE_OF(word)(octet, [&](std::size_t ray) EYEBRIDGE_RAY_TARGET {
          return (left_of_a(ray) >= -error) & (left_of_b(ray) <= error);
        });
      }
      if (bits_of(ends.along) != 0) [[unlikely]] {
        for (std::size_t i = 0; i < Pairs::kRays; ++i) {
          word |= std::uint64_t{bits_of(ends.along)} << (i * Pairs::kLanes);
        }
      }
      const std::size_t rest = count - octet * Pairs::kRays;
      if (rest < Pairs::kRays) word &= (std::uint64_t{1} << (rest * Pairs::kLanes)) - 1;
      if (pairs.is_full()) [[unlikely]] {
        EYEBRIDGE_OF(meet)(segments, walls.indices.data(), pairs);
      }
      pairs.add(word, k, octet);
    }
  }
  if (pairs.size() != 0) EYEBRIDGE_OF(meet)(segments, walls.indices.data(), pairs);
}

/// nearer_hit() of the pairs: the same operations on the same numbers.
EYEBRIDGE_RAY_TARGET
void Fan::EYEBRIDGE_OF(meet)(const Segment* segments, const std::uint32_t* indices, Pairs& pairs) {
  const LaneBits sign_bit = LaneBits{} + std::numeric_limits<std::int64_t>::min();
  const Lanes zero{};
  const Lanes never = zero + std::numeric_limits<double>::infinity();
  pairs.fill_up(kLanes);
  for (std::size_t k = 0; k < pairs.size(); k += kLanes) {
    const auto wall = [&](std::size_t lane) -> const Segment& {
      return segments[indices[pairs.thing(k + lane)]];
    };
    const auto ray = [&](std::size_t lane) { return directions_[pairs.ray(k + lane)]; };
    const Lanes wx = lanes_of([&](std::size_t i) { return wall(i).a.x; }) - origin_.x;
    const Lanes wy = lanes_of([&](std::size_t i) { return wall(i).a.y; }) - origin_.y;
    const Lanes ux = lanes_of([&](std::size_t i) { return wall(i).u.x; });
    const Lanes uy = lanes_of([&](std::size_t i) { return wall(i).u.y; });
    const Lanes length = lanes_of([&](std::size_t i) { return wall(i).length; });
    const Lanes dx = lanes_of([&](std::size_t i) { return ray(i).x; });
    const Lanes dy = lanes_of([&](std::size_t i) { return ray(i).y; });
    const LaneBits signed_den = (LaneBits)(dx * uy - dy * ux);
    const LaneBits sign = signed_den & sign_bit;
    const Lanes den = (Lanes)(signed_den ^ sign);
    const Lanes along_ray = (Lanes)((LaneBits)(wx * uy - wy * ux) ^ sign);
    const Lanes along_wall = (Lanes)((LaneBits)(wx * dy - wy * dx) ^ sign);
    const Lanes slack = kRayTolerance * den;
    const LaneBits parallel = den < kParallel;
    const LaneBits hit = (along_wall >= -slack) & (along_wall <= length * den + slack) &
                         (along_ray >= -slack) & ~parallel;
    const Lanes along = along_ray / den;
    const Lanes range = hit ? (along > zero ? along : zero) : never;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      double& best = best_[pairs.ray(k + lane)];
      best = range[lane] < best ? range[lane] : best;
    }
    if (!any(parallel)) [[likely]] {
      continue;
    }
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      double& best = best_[pairs.ray(k + lane)];
      best = nearer_hit(wall(lane), origin_, ray(lane), best);
    }
  }
  pairs.clear();
}

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
  const auto list = [&](auto has_more) EYEBRIDGE_RAY_TARGET {
    for (const std::uint32_t start : starts) {
      const Floats x = x0 - load(xs + start);
      const Floats y = y0 - load(ys + start);
      const auto to_line = [&](std::size_t i) EYEBRIDGE_RAY_TARGET {
        return magnitude(x * line_y[i] - y * line_x[i]);
      };
      // What is no number, as there is no such line, comes first, and the other one is smaller.
      Floats across = smaller(smaller(to_line(3), to_line(2)), smaller(to_line(1), to_line(0)));
      if constexpr (has_more) {
        for (std::size_t i = 4; i < lines; ++i) {
          across = smaller(magnitude(x * y_[i] - y * x_[i]), across);
        }
      }
      const std::uint32_t mine = self - start;
      const unsigned own = (mine < kFloats ? 1U : 0U) << mine % kFloats;
      const unsigned near = bits_of(across <= load(radii + start) + error) & ~own;
      pairs = list_lanes(near, code + start, pairs);
    }
  };
  if (lines <= 4) [[likely]] {
    list(std::false_type{});
  } else {
    list(std::true_type{});
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
                                     {looks.list.starts + begin, looks.ends[f] - begin}, code, end);
      begin = looks.ends[f];
    }
    for (const std::uint32_t* pair = looks.pairs; pair != end; ++pair) {
      fans[*pair >> Looks::kDiscBits].EYEBRIDGE_OF(meet)(rows.discs[*pair & Looks::kDisc]);
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
                            largest_radius + kExtentMargin);
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
  const Lanes zero{};
  const Lanes never = zero + std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; i += kLanes) {
    Lanes dx;
    Lanes dy;
    Lanes best;
    load(dx, dx_ + i);
    load(dy, dy_ + i);
    load(best, best_ + i);
    const Lanes along = wx * dx + wy * dy;
    const Lanes across = dx * wy - dy * wx;
    // No number for rays that pass by: `best` is smaller then.
    const Lanes range = along - root_of(radius_squared - across * across);
    // Nothing else from one disc to the next: it is what they wait for.
    best = smaller(along > zero ? range : never, best);
    std::memcpy(best_ + i, &best, sizeof best);
  }
}
