#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

#include "eyebridge/base/instruction_sets.hpp"
#include "run_list.hpp"
#include "sweep.hpp"
#include "sweep_bearings.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep_discs.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace eyebridge::world::HWY_NAMESPACE {
namespace {

#include "lanes.ipp"
#include "lanes_bearings.ipp"
#include "lanes_discs.ipp"

/// The rays `first` to `last`, and maybe neighbours of theirs, and a disc at `w` from the origin,
/// which is not in it.
HWY_INLINE void meet_run(Sweep& sweep, Vec2 w, double radius, std::size_t first, std::size_t last) {
  const double radius_squared = radius * radius;
  // Most discs are so far away that few rays go their way.
  std::size_t i = first;
  do {
    meet_register(w, radius_squared, sweep.dx + i, sweep.dy + i, sweep.best + i);
    i += kLanes;
  } while (i <= last);
}

void meet_disc(Sweep& sweep, const Disc& disc) {
  const Vec2 w = Vec2{disc.x, disc.y} - sweep.origin;
  if (norm_squared(w) - disc.radius * disc.radius <= 0.0) {
    for (double& range : sweep.ranges()) range = range > 0.0 ? 0.0 : range;
    return;
  }
  // asin(s) <= s + (pi / 2 - 1) s^3: all terms of its series are positive, and equal at 1.
  const double sine = std::min(disc.radius / norm(w), 1.0);
  const double angle = sine + 0.5708 * sine * sine * sine + kBearingError;
  const double number = sweep.number_of(w);
  const double half_width = angle * sweep.per_gap + kRayMargin;
  sweep.each_between(number - half_width, number + half_width,
                     [&](std::size_t first, std::size_t last)
                         HWY_ATTR { meet_run(sweep, w, disc.radius, first, last); });
}

void meet_each(Sweep& sweep, std::span<const Disc> discs, BodyId ignore) {
  for (const Disc& disc : discs) {
    if (disc.id != ignore) meet_disc(sweep, disc);
  }
}

/// How far each ray and the kWindow - 1 next ones go, at most.
HWY_INLINE void find_horizons(const Sweep& sweep, float* horizons) {
  // Ranges beyond the last ray are no more than 0; of what is not filled no ray's horizon is made.
  static_assert(Sweep::kWindow + kLanes - 1 <= Sweep::kBeyond && kFloats <= Sweep::kBeyond);
  constexpr hn::Rebind<float, decltype(kDouble)> kHalf;
  float ranges[Sweep::kMost + 2 * Sweep::kBeyond];
  for (std::size_t i = 0; i < sweep.count + Sweep::kWindow; i += kLanes) {
    hn::StoreU(hn::DemoteTo(kHalf, load(sweep.best + i)), kHalf, ranges + i);
  }
  for (std::size_t i = 0; i < sweep.count; i += kFloats) {
    Floats most = load(ranges + i);
    for (std::size_t k = 1; k < Sweep::kWindow; ++k) most = hn::Max(most, load(ranges + i + k));
    hn::StoreU(most * filled(1.00001F), kFloat, horizons + i);
  }
}

/// A byte for each register of a list of `kMost`: bits of lanes.
template <std::size_t kMost>
struct LaneMarks {
  static constexpr std::size_t kWord = sizeof(std::uint64_t);

  explicit LaneMarks(std::size_t size) { std::memset(bytes + size / kWord * kWord, 0, kWord); }

  /// Calls visit(n, lane) for each lane that is set in the first `size` registers.
  template <class Visit>
  HWY_INLINE void each(std::size_t size, Visit visit) const {
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

/// Looks at discs, a register at a time.
struct DiscLook {
  BodyMap::Rows rows;
  const float* horizons;  ///< Of the rays.
  Directions ahead;
  float rim;  ///< Horizon of the rays next to where the numbers begin and end.
  float x0, y0, error, per_gap, period, last, margin;

  /// Bits of those lanes whose rays are one run, the one that first[] and last[] say, and of the
  /// others.
  struct Seen {
    std::uint8_t plain, others;
  };
  HWY_INLINE Seen at(std::size_t start, float* first_rays, float* last_rays) const {
    const Floats x = load(rows.x + start) - filled(x0);
    const Floats y = load(rows.y + start) - filled(y0);
    const Floats radius = load(rows.radius + start) + filled(error);
    const Floats square = x * x + y * y;
    const Floats inverse = inverse_root_of(square);
    const Floats distance = square * inverse * filled(1.0F - static_cast<float>(kRoughError));
    const Floats number = rough_bearing_of(x, y, inverse, ahead) * filled(per_gap);
    // As in meet_disc().
    const Floats sine = radius * inverse * filled(1.0F + static_cast<float>(kRoughError));
    const Floats angle = sine + filled(0.5708F) * sine * sine * sine;
    const Floats width = angle * filled(per_gap) + filled(margin);
    const Floats low = number - width;
    const Floats high = number + width;
    const Floats zero = hn::Zero(kFloat);
    const Floats end = filled(last);
    // The margin is more than a ray that lies at `low`.
    const Floats first = low + filled(1.0F);
    hn::StoreU(first, kFloat, first_rays);
    hn::StoreU(high, kFloat, last_rays);
    // Rays before the first one, and NaN, as of no disc, must not lead out of the table.
    const Floats here = hn::Min(hn::Max(first, zero), end);
    const Floats horizon = hn::GatherIndex(kFloat, horizons, hn::ConvertTo(kInt, here));
    const Floats nearest = distance - radius;
    const FloatMask wide = width > filled(Sweep::kWindow / 2.0F);
    const FloatMask beside = hn::And(low > end, high < filled(period));
    const FloatMask inside = hn::And(low >= zero, high <= end);
    const FloatMask around = sine >= filled(0.99F);
    const FloatMask seen = hn::Or(nearest <= horizon, wide);
    const FloatMask seen_at_rim = hn::Or(nearest <= filled(rim), wide);
    const FloatMask plain = hn::AndNot(around, hn::And(seen, inside));
    const FloatMask others = hn::Or(around, hn::AndNot(hn::Or(inside, beside), seen_at_rim));
    return {static_cast<std::uint8_t>(bits_of(plain)), static_cast<std::uint8_t>(bits_of(others))};
  }
};

void meet_discs(Sweep& sweep, const BodyMap& map, double largest_radius) {
  const BodyMap::Rows rows = map.rows();
  const std::size_t count = sweep.count;
  float horizons[Sweep::kMost + Sweep::kBeyond];
  find_horizons(sweep, horizons);
  const float end = horizons[count > Sweep::kWindow ? count - Sweep::kWindow : 0];
  const DiscLook look{rows,
                      horizons,
                      directions({sweep.dx[0], sweep.dy[0]}, sweep.turn),
                      std::max(horizons[0], end),
                      static_cast<float>(sweep.origin.x),
                      static_cast<float>(sweep.origin.y),
                      static_cast<float>(map.error(sweep.origin)),
                      static_cast<float>(sweep.per_gap),
                      static_cast<float>(sweep.period),
                      static_cast<float>(count - 1),
                      static_cast<float>(kRoughError * sweep.per_gap + 2 * kRayMargin)};
  constexpr std::size_t kListed = 64;
  using List = Registers<kListed>;
  constexpr std::size_t kRoom = (sizeof(List::items) / sizeof(std::uint32_t) + 1) * kFloats;
  List list;
  float firsts[kRoom];
  float lasts[kRoom];
  const auto look_at_list = [&]() HWY_ATTR {
    LaneMarks<kListed> plain(list.size);
    LaneMarks<kListed> others(list.size);
    // Copies: what is written might be these, for all that the compiler knows.
    const DiscLook look_here = look;
    const std::size_t size = list.size;
    for (std::size_t n = 0; n < size; ++n) {
      const DiscLook::Seen seen =
          look_here.at(list.items[n], firsts + n * kFloats, lasts + n * kFloats);
      plain.bytes[n] = seen.plain;
      others.bytes[n] = seen.others;
    }
    plain.each(size, [&](std::size_t n, std::size_t lane) HWY_ATTR {
      const Disc& disc = rows.discs[list.items[n] + lane];
      const std::size_t k = n * kFloats + lane;
      meet_run(sweep, Vec2{disc.x, disc.y} - sweep.origin, disc.radius,
               static_cast<std::uint32_t>(firsts[k]), static_cast<std::uint32_t>(lasts[k]));
    });
    others.each(size, [&](std::size_t n, std::size_t lane)
                          HWY_ATTR { meet_disc(sweep, rows.discs[list.items[n] + lane]); });
    list.size = 0;
  };
  list.add_box(
      map, rows.nobody,
      [&]() HWY_ATTR {
        return box_around(map, sweep.origin, sweep.dx, sweep.dy, sweep.best, count,
                          largest_radius + kExtentMargin);
      },
      look_at_list);
  look_at_list();
}

}  // namespace
}  // namespace eyebridge::world::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyebridge::world {

void Sweep::meet_discs(std::span<const Disc> discs, BodyId ignore) {
  EYEBRIDGE_BEST(meet_each)(*this, discs, ignore);
}

void Sweep::meet_discs(const BodyMap& map, double largest_radius) {
  EYEBRIDGE_BEST(meet_discs)(*this, map, largest_radius);
}

}  // namespace eyebridge::world
#endif
