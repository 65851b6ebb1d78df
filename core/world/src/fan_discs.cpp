#include <cassert>
#include <cstdint>
#include <limits>

#include "eyebridge/base/instruction_sets.hpp"
#include "fan.hpp"
#include "run_list.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fan_discs.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace eyebridge::world::HWY_NAMESPACE {
namespace {

#include "lanes.ipp"
#include "lanes_discs.ipp"

/// For each value of eight bits: the numbers of the bits that are set, in order.
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
/// and returns the place after them. No branch: nobody can foresee how many there are. Highway's
/// CompressStore() copies its table to the stack each time, by g++ 12.
HWY_INLINE std::uint32_t* list_lanes(std::uint32_t bits, std::uint32_t first, std::uint32_t* at) {
  constexpr hn::Rebind<std::uint8_t, decltype(kUnsigned)> kBytes;
  const auto lanes = hn::PromoteTo(kUnsigned, hn::LoadU(kBytes, kLaneTable.numbers[bits]));
  hn::StoreU(lanes + hn::Set(kUnsigned, first), kUnsigned, at);
  return at + hwy::PopCount(bits);
}

/// nearer_disc_hit() of all rays: the same operations on the same numbers.
HWY_INLINE void meet(Fan& fan, const Disc& disc) {
  const Vec2 w = Vec2{disc.x, disc.y} - fan.origin;
  const double radius_squared = disc.radius * disc.radius;
  const std::size_t count = fan.directions.size();
  if (norm_squared(w) - radius_squared <= 0.0) [[unlikely]] {
    for (std::size_t i = 0; i < count; ++i) fan.best[i] = fan.best[i] > 0.0 ? 0.0 : fan.best[i];
    return;
  }
  for (std::size_t i = 0; i < count; i += kLanes) {
    meet_register(w, radius_squared, fan.dx + i, fan.dy + i, fan.best + i);
  }
}

/// The same for rays that begin at places of their own.
void meet_apart(Fan& fan, const Disc& disc) {
  const Doubles zero = hn::Zero(kDouble);
  const Doubles radius_squared = filled(disc.radius * disc.radius);
  for (std::size_t i = 0; i < fan.directions.size(); i += kLanes) {
    const Doubles wx = filled(disc.x) - load(fan.ox + i);
    const Doubles wy = filled(disc.y) - load(fan.oy + i);
    const DoubleMask inside = wx * wx + wy * wy - radius_squared <= zero;
    const Doubles range = range_to_disc(wx, wy, radius_squared, load(fan.dx + i), load(fan.dy + i));
    hn::StoreU(hn::Min(hn::IfThenElse(inside, zero, range), load(fan.best + i)), kDouble,
               fan.best + i);
  }
}

/// Which discs are near which fans, step by step.
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

/// Lists the discs of the registers of `rows` that begin at `starts` that are near a line, each +
/// `code`, at `pairs`; returns the end. The floats may be `off` by this many metres. `kMore`: there
/// are more lines than four; a loop through them would cost a tenth of all that a fan does.
template <bool kApart, bool kMore>
HWY_INLINE std::uint32_t* list_near(const Fan& fan, const BodyMap::Rows& rows, double off,
                                    std::span<const std::uint32_t> starts, std::uint32_t code,
                                    std::uint32_t* pairs) {
  const Floats x0 = filled(static_cast<float>(fan.origin.x));
  const Floats y0 = filled(static_cast<float>(fan.origin.y));
  const Floats error = filled(static_cast<float>(off));
  const Floats line_x[] = {filled(fan.x[0]), filled(fan.x[1]), filled(fan.x[2]), filled(fan.x[3])};
  const Floats line_y[] = {filled(fan.y[0]), filled(fan.y[1]), filled(fan.y[2]), filled(fan.y[3])};
  const auto shift = [&](std::size_t i) HWY_ATTR { return filled(kApart ? fan.beside[i] : 0.0F); };
  const Floats beside[] = {shift(0), shift(1), shift(2), shift(3)};
  // Copies: what is written might be these, for all that the compiler knows.
  const float* const xs = rows.x;
  const float* const ys = rows.y;
  const float* const radii = rows.radius;
  const std::size_t lines = fan.lines;
  const std::uint32_t self = fan.self;
  for (const std::uint32_t start : starts) {
    const Floats x = x0 - load(xs + start);
    const Floats y = y0 - load(ys + start);
    const auto to_line = [&](std::size_t i) HWY_ATTR {
      const Floats across = x * line_y[i] - y * line_x[i];
      return hn::Abs(kApart ? across + beside[i] : across);
    };
    // NaN, of a line that there is not, comes first: Min() gives the second then.
    Floats across = hn::Min(hn::Min(to_line(3), to_line(2)), hn::Min(to_line(1), to_line(0)));
    if constexpr (kMore) {
      for (std::size_t i = 4; i < lines; ++i) {
        const Floats more = x * filled(fan.y[i]) - y * filled(fan.x[i]) + shift(i);
        across = hn::Min(hn::Abs(more), across);
      }
    }
    const std::uint32_t mine = self - start;
    const std::uint32_t own = (mine < kFloats ? 1U : 0U) << mine % kFloats;
    const std::uint32_t near = bits_of(across <= load(radii + start) + error) & ~own;
    pairs = list_lanes(near, code + start, pairs);
  }
  return pairs;
}

template <bool kApart>
HWY_INLINE std::uint32_t* look(const Fan& fan, const BodyMap& map,
                               std::span<const std::uint32_t> starts, std::uint32_t code,
                               std::uint32_t* pairs) {
  const double off = map.error(fan.origin);
  return fan.lines <= 4 ? list_near<kApart, false>(fan, map.rows(), off, starts, code, pairs)
                        : list_near<kApart, true>(fan, map.rows(), off, starts, code, pairs);
}

void meet_discs(std::span<Fan> fans, const BodyMap& map, double largest_radius) {
  Looks looks;
  const BodyMap::Rows rows = map.rows();
  assert(rows.nobody <= Looks::kDisc);
  std::size_t first = 0;  // of those in the list
  // Loops through all fans at once are long: where one ends nobody can foresee.
  const auto look_at_list = [&](std::size_t last) HWY_ATTR {
    looks.ends[last] = static_cast<std::uint32_t>(looks.list.size);
    std::uint32_t* end = looks.pairs;
    std::size_t begin = 0;
    for (std::size_t f = first; f <= last; ++f) {
      const auto code = static_cast<std::uint32_t>(f << Looks::kDiscBits);
      const std::span<const std::uint32_t> starts{looks.list.items + begin, looks.ends[f] - begin};
      end = fans[f].apart ? look<true>(fans[f], map, starts, code, end)
                          : look<false>(fans[f], map, starts, code, end);
      begin = looks.ends[f];
    }
    for (const std::uint32_t* pair = looks.pairs; pair != end; ++pair) {
      Fan& fan = fans[*pair >> Looks::kDiscBits];
      const Disc& disc = rows.discs[*pair & Looks::kDisc];
      if (fan.apart) {
        meet_apart(fan, disc);
      } else {
        meet(fan, disc);
      }
    }
    looks.list.size = 0;
    first = last;
  };
  for (std::size_t f = 0; f < fans.size(); ++f) {
    const Fan& fan = fans[f];
    looks.list.add_box(
        map, rows.nobody,
        [&]() HWY_ATTR {
          return box_around(map, fan.origin, fan.dx, fan.dy, fan.best, fan.directions.size(),
                            largest_radius + fan.spread + kExtentMargin);
        },
        [&]() HWY_ATTR { look_at_list(f); });
    looks.ends[f] = static_cast<std::uint32_t>(looks.list.size);
  }
  look_at_list(fans.size() - 1);
}

}  // namespace
}  // namespace eyebridge::world::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyebridge::world {

void Fan::meet_discs(std::span<Fan> fans, const BodyMap& map, double largest_radius) {
  EYEBRIDGE_BEST(meet_discs)(fans, map, largest_radius);
}

}  // namespace eyebridge::world
#endif
