#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "eyebridge/base/instruction_sets.hpp"
#include "run_list.hpp"
#include "sweep.hpp"
#include "sweep_bearings.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep_walls.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace eyebridge::world::HWY_NAMESPACE {
namespace {

#include "lanes.ipp"
#include "lanes_bearings.ipp"
#include "lanes_walls.ipp"

/// Some walls of a WallList, and the registers of rays that each of them may meet.
struct WallMeetings {
  static constexpr std::size_t kWalls = 256;
  static constexpr unsigned kRayBits = 16;
  static_assert(Sweep::kMost <= std::size_t{1} << kRayBits && kWalls % kFloats == 0);

  SeenWall walls[kWalls];
  RunList<1024, 8, kLanes> list;  ///< A wall and, in the lower bits, the first ray.

  [[nodiscard]] std::size_t wall_of(std::size_t item) const { return list.items[item] >> kRayBits; }
  [[nodiscard]] std::size_t ray_of(std::size_t item) const {
    return list.items[item] & ((std::uint32_t{1} << kRayBits) - 1);
  }

  /// Adds `count` registers that begin with `ray`, as RunList does.
  template <class Full>
  HWY_INLINE void add(std::size_t wall, std::size_t ray, std::size_t count, Full full) {
    list.add(static_cast<std::uint32_t>(wall << kRayBits | ray), count, full);
  }

  /// nearer_hit() of all that are listed. False when a ray may be parallel to a wall: such rays are
  /// left as they are.
  bool meet(Sweep& sweep) const {
    const Doubles never = filled(std::numeric_limits<double>::infinity());
    DoubleMask parallel = never < never;
    for (std::size_t k = 0; k < list.size; ++k) {
      const std::size_t ray = ray_of(k);
      const WallHits hits =
          hits_of(filled(walls[wall_of(k)]), load(sweep.dx + ray), load(sweep.dy + ray));
      parallel = hn::Or(parallel, hits.parallel);
      // Nobody can foresee which of them are met: dividing is cheaper than asking.
      const Doubles range = hn::Max(hits.along_ray / hits.den, hn::Zero(kDouble));
      const Doubles met = hn::IfThenElse(hits.hit, range, never);
      hn::StoreU(hn::Min(met, load(sweep.best + ray)), kDouble, sweep.best + ray);
    }
    return hn::AllFalse(kDouble, parallel);
  }
};

/// Runs of rays that a register of walls may meet, and by how much they are off.
struct WallRuns {
  Floats first, last;  ///< Numbers of rays: from less than a turn to not less than 0.
  FloatMask beside;    ///< No ray goes there.
  FloatMask one_run;
};

HWY_INLINE WallRuns runs_of(const Sweep& sweep, const Ends& ends, float wall_error) {
  const Floats per_gap = filled(static_cast<float>(sweep.per_gap));
  const Floats period = filled(static_cast<float>(sweep.period));
  const Floats last_ray = filled(static_cast<float>(sweep.count - 1));
  const auto margin = static_cast<float>(2 * kBearingError * sweep.per_gap + 2 * kRayMargin);
  const Floats zero = hn::Zero(kFloat);
  const Directions ahead = directions({sweep.dx[0], sweep.dy[0]}, sweep.turn);
  const Bearing a = bearing_of(ends.ax, ends.ay, ahead);
  const Bearing b = bearing_of(ends.bx, ends.by, ahead);
  const FloatMask forward = filled(static_cast<float>(sweep.turn)) * ends.area > zero;
  const Floats low = hn::IfThenElse(forward, a.angle, b.angle) * per_gap;
  const Floats next = hn::IfThenElse(forward, b.angle, a.angle) * per_gap;
  const Floats high = hn::IfThenElse(next < low, next + period, next);
  // By how much ends that are this far off may seem to be elsewhere.
  const Floats nearness = hn::Max(a.nearness, b.nearness);
  const Floats off = filled(margin) + filled(1.2F * wall_error) * nearness * per_gap;
  const FloatMask all = hn::Or(ends.along, filled(wall_error) * nearness >= filled(0.3F));
  const Floats first = hn::IfThenZeroElse(all, low - off);
  const Floats last = hn::IfThenElse(all, period, high + off);
  const FloatMask beside = hn::And(first > last_ray, last < period);
  const FloatMask one_run = hn::AndNot(beside, hn::And(first >= zero, last < period));
  return {first, last, beside, one_run};
}

void meet_walls(Sweep& sweep, const Segment* segments, const WallList& walls) {
  const auto error = static_cast<float>(walls.error);
  const Floats last_ray = filled(static_cast<float>(sweep.count - 1));
  WallMeetings meetings;
  std::size_t begin = 0;  // of `meetings`, in the list
  const auto meet_listed = [&]() HWY_ATTR {
    if (!meetings.meet(sweep)) {
      for (std::size_t k = 0; k < meetings.list.size; ++k) {
        const Segment& wall = segments[walls.indices[begin + meetings.wall_of(k)]];
        const std::size_t first = meetings.ray_of(k);
        for (std::size_t ray = first; ray < first + kLanes; ++ray) {
          const Vec2 direction{sweep.dx[ray], sweep.dy[ray]};
          if (std::fabs(cross(direction, wall.u)) < kParallel) {
            sweep.best[ray] = nearer_hit(wall, sweep.origin, direction, sweep.best[ray]);
          }
        }
      }
    }
    meetings.list.size = 0;
  };
  HWY_ALIGN std::int32_t starts[kFloats];
  HWY_ALIGN std::int32_t counts[kFloats];
  for (std::size_t k = 0; k < walls.indices.size(); k += kFloats) {
    if (k - begin == WallMeetings::kWalls) {
      meet_listed();
      begin = k;
    }
    const WallRuns runs = runs_of(sweep, ends_of(walls, k, sweep.origin), error);
    // Whole registers of rays. The margin is more than a ray that lies at `first`; where no ray is
    // between the two, mostly none.
    constexpr auto kWhole = static_cast<std::int32_t>(kLanes);
    const auto one_run = hn::RebindMask(kInt, runs.one_run);
    const Ints after = hn::ConvertTo(kInt, runs.first + filled(1.0F));
    const Ints until = hn::ConvertTo(kInt, hn::Min(runs.last, last_ray));
    const Ints start = hn::IfThenElseZero(one_run, hn::And(after, hn::Set(kInt, -kWhole)));
    const Ints end = hn::IfThenElseZero(one_run, until + hn::Set(kInt, kWhole));
    hn::Store(start, kInt, starts);
    hn::Store(hn::ShiftRight<std::countr_zero(kLanes)>(end - start), kInt, counts);
    const std::size_t rest = walls.indices.size() - k;
    const std::size_t here = rest < kFloats ? rest : kFloats;
    const std::size_t slot = k - begin;
    for (std::size_t i = 0; i < here; ++i) {
      meetings.walls[slot + i] = seen(segments[walls.indices[k + i]], sweep.origin);
      meetings.add(slot + i, static_cast<std::size_t>(starts[i]),
                   static_cast<std::size_t>(counts[i]), meet_listed);
    }
    std::uint32_t others = ~bits_of(hn::Or(runs.one_run, runs.beside)) & ((1U << here) - 1U);
    if (others == 0) continue;
    HWY_ALIGN float first[kFloats];
    HWY_ALIGN float last[kFloats];
    hn::Store(runs.first, kFloat, first);
    hn::Store(runs.last, kFloat, last);
    for (; others != 0; others &= others - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(others));
      sweep.each_between(first[i], last[i], [&](std::size_t from, std::size_t to) HWY_ATTR {
        meetings.add(slot + i, from / kLanes * kLanes, to / kLanes - from / kLanes + 1,
                     meet_listed);
      });
    }
  }
  meet_listed();
}

}  // namespace
}  // namespace eyebridge::world::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyebridge::world {

void Sweep::meet_walls(const Segment* segments, const WallList& walls) {
  EYEBRIDGE_BEST(meet_walls)(*this, segments, walls);
}

}  // namespace eyebridge::world
#endif
