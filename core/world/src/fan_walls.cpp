#include <cstdint>
#include <limits>

#include "eyebridge/base/instruction_sets.hpp"
#include "fan.hpp"
#include "fan_pairs.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fan_walls.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace eyebridge::world::HWY_NAMESPACE {
namespace {

#include "lanes.ipp"
#include "lanes_walls.ipp"

/// nearer_hit() of the pairs.
void meet_pairs(Fan& fan, const Segment* segments, const std::uint32_t* indices, Pairs& pairs) {
  const Doubles never = filled(std::numeric_limits<double>::infinity());
  pairs.fill_up(kLanes);
  for (std::size_t k = 0; k < pairs.size(); k += kLanes) {
    const auto wall = [&](std::size_t lane) HWY_ATTR -> const Segment& {
      return segments[indices[pairs.thing(k + lane)]];
    };
    const auto ray = [&](std::size_t lane) HWY_ATTR { return pairs.ray(k + lane); };
    Points ends = points_at([&](std::size_t i) HWY_ATTR { return &wall(i).a.x; });
    if (fan.apart) {
      const Points from = points_at([&](std::size_t i) HWY_ATTR { return &fan.origins[ray(i)].x; });
      ends = {ends.x - from.x, ends.y - from.y};
    } else {
      ends = {ends.x - filled(fan.origin.x), ends.y - filled(fan.origin.y)};
    }
    const Points along = points_at([&](std::size_t i) HWY_ATTR { return &wall(i).u.x; });
    const Doubles lengths = points_at([&](std::size_t i) HWY_ATTR { return &wall(i).u.y; }).y;
    const Points rays =
        points_at([&](std::size_t i) HWY_ATTR { return &fan.directions[ray(i)].x; });
    const WallHits hits =
        hits_of({ends.x, ends.y, along.x, along.y, lengths, ends.x * along.y - ends.y * along.x},
                rays.x, rays.y);
    const Doubles met = hn::Max(hits.along_ray / hits.den, hn::Zero(kDouble));
    HWY_ALIGN double ranges[kLanes];
    hn::Store(hn::IfThenElse(hits.hit, met, never), kDouble, ranges);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      double& best = fan.best[ray(lane)];
      best = ranges[lane] < best ? ranges[lane] : best;
    }
    if (hn::AllFalse(kDouble, hits.parallel)) [[likely]] {
      continue;
    }
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      double& best = fan.best[ray(lane)];
      best = nearer_hit(wall(lane), fan.origin_of(ray(lane)), fan.directions[ray(lane)], best);
    }
  }
  pairs.clear();
}

/// Which of a register of walls are met by a ray, and by one that looks the other way.
struct Met {
  FloatMask there, back;
};

/// A register of walls, their ends turned so that b is to the left of a. `kApart`: the rays begin
/// at places of their own.
template <bool kApart>
struct TurnedWalls {
  Floats ax, ay, bx, by;
  Floats error;
  Floats sign;        ///< Of what is turned.
  FloatMask between;  ///< The wall's line goes between where rays begin.

  HWY_INLINE TurnedWalls(const Ends& ends, float off, float spread)
      : error(filled(off)),
        sign(hn::And(ends.area, hn::SignBit(kFloat))),
        between(hn::Or(ends.along, hn::Abs(ends.area) <= filled(spread) * ends.length)) {
    ax = hn::Xor(ends.ax, sign);
    ay = hn::Xor(ends.ay, sign);
    bx = hn::Xor(ends.bx, sign);
    by = hn::Xor(ends.by, sign);
  }

  HWY_INLINE Floats left_of(const Fan& fan, Floats x, Floats y, std::size_t ray) const {
    const Floats left = x * filled(fan.y[ray]) - y * filled(fan.x[ray]);
    return kApart ? left - hn::Xor(filled(fan.beside[ray]), sign) : left;
  }

  /// A ray that looks the other way has both ends on the other sides.
  HWY_INLINE Met met(const Fan& fan, std::size_t ray) const {
    const Floats a = left_of(fan, ax, ay, ray);
    const Floats b = left_of(fan, bx, by, ray);
    const Floats least = hn::Neg(error);
    const FloatMask there = hn::And(a >= least, b <= error);
    const FloatMask back = hn::And(a <= error, b >= least);
    if constexpr (!kApart) return {there, back};
    // A wall's line that goes between them is seen from its other side by some of the rays.
    return {hn::Or(there, hn::And(back, between)), hn::Or(back, hn::And(there, between))};
  }
};

template <bool kApart>
void find_pairs(Fan& fan, const Segment* segments, const WallList& walls, Pairs& pairs) {
  const std::size_t count = fan.directions.size();
  const auto error = static_cast<float>(walls.error);
  const auto spread = static_cast<float>(fan.spread + 2 * walls.error) + kNear;
  const bool both_ways = 2 * fan.lines == count && fan.lines <= 4;
  const auto mask_of = [](std::size_t rays)
                           HWY_ATTR { return (std::uint64_t{1} << (rays * Pairs::kLanes)) - 1; };
  for (std::size_t k = 0; k < walls.indices.size(); k += kFloats) {
    const Ends ends = ends_of(walls, k, fan.origin);
    const TurnedWalls<kApart> turned(ends, error, spread);
    for (std::size_t octet = 0; octet * Pairs::kRays < count; ++octet) {
      const std::size_t first = octet * Pairs::kRays;
      const std::size_t rest = count - first;
      const auto there = [&](std::size_t i) HWY_ATTR {
        return std::uint64_t{bits_of(turned.met(fan, first + i).there)} << (i * Pairs::kLanes);
      };
      std::uint64_t word = 0;
      if (both_ways) {
        std::uint64_t back = 0;
        for (std::size_t i = 0; i < 4; ++i) {
          const Met both = turned.met(fan, i);
          word |= std::uint64_t{bits_of(both.there)} << (i * Pairs::kLanes);
          back |= std::uint64_t{bits_of(both.back)} << (i * Pairs::kLanes);
        }
        // There may be fewer lines than four.
        word = (word & mask_of(fan.lines)) | back << (fan.lines * Pairs::kLanes);
      } else {
        word = there(0) | there(1) | there(2) | there(3);
        if (rest > 4) word |= there(4) | there(5) | there(6) | there(7);
      }
      if (const std::uint64_t along = bits_of(ends.along); along != 0) [[unlikely]] {
        for (std::size_t i = 0; i < Pairs::kRays; ++i) word |= along << (i * Pairs::kLanes);
      }
      if (rest < Pairs::kRays) word &= mask_of(rest);
      if (pairs.is_full()) [[unlikely]] {
        meet_pairs(fan, segments, walls.indices.data(), pairs);
      }
      pairs.add(word, k, octet);
    }
  }
}

void meet_walls(Fan& fan, const Segment* segments, const WallList& walls) {
  Pairs pairs;
  if (fan.apart) {
    find_pairs<true>(fan, segments, walls, pairs);
  } else {
    find_pairs<false>(fan, segments, walls, pairs);
  }
  if (pairs.size() != 0) meet_pairs(fan, segments, walls.indices.data(), pairs);
}

}  // namespace
}  // namespace eyebridge::world::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyebridge::world {

void Fan::meet_walls(const Segment* segments, const WallList& walls) {
  EYEBRIDGE_BEST(meet_walls)(*this, segments, walls);
}

}  // namespace eyebridge::world
#endif
