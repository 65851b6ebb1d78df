// How the rays of a Sweep meet walls. Included by one source per instruction set; it has defined
// EYEBRIDGE_OF(name), what a member function of that name is called there, and what ray_lanes.ipp
// asks for.

#include "bearing_lanes.ipp"
#include "run_list.ipp"
#include "wall_lanes.ipp"

namespace {

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
  EYEBRIDGE_RAY_TARGET void add(std::size_t wall, std::size_t ray, std::size_t count, Full full) {
    list.add(static_cast<std::uint32_t>(wall << kRayBits | ray), count, full);
  }

  /// nearer_hit() of all that are listed. False when a ray may be parallel to a wall: such rays are
  /// left as they are.
  EYEBRIDGE_RAY_TARGET bool meet(const double* dx, const double* dy, double* best) const {
    const Lanes never = Lanes{} + std::numeric_limits<double>::infinity();
    LaneBits parallel{};
    for (std::size_t k = 0; k < list.size; ++k) {
      const std::size_t ray = ray_of(k);
      Lanes x;
      Lanes y;
      load(x, dx + ray);
      load(y, dy + ray);
      const WallHits hits = hits_of(walls[wall_of(k)], x, y);
      parallel |= hits.parallel;
      // Nobody can foresee which of them are met: dividing is cheaper than asking.
      const Lanes range = hits.along_ray / hits.den;
      Lanes nearest;
      load(nearest, best + ray);
      nearest = smaller(hits.hit ? larger(range, Lanes{}) : never, nearest);
      std::memcpy(best + ray, &nearest, sizeof nearest);
    }
    return !any(parallel);
  }
};

}  // namespace

EYEBRIDGE_RAY_TARGET
void Sweep::EYEBRIDGE_OF(meet_walls)(const Segment* segments, const WallList& walls) {
  const auto error = static_cast<float>(walls.error);
  const auto turn = static_cast<float>(turn_);
  const auto period = static_cast<float>(period_);
  const auto per_gap = static_cast<float>(per_gap_);
  const auto last_ray = static_cast<float>(count_ - 1);
  const auto margin = static_cast<float>(2 * kBearingError * per_gap_ + 2 * kRayMargin);
  const Directions ahead = directions({dx[0], dy[0]}, turn_);
  WallMeetings meetings;
  std::size_t begin = 0;  // of `meetings`, in the list
  const auto meet_listed = [&]() EYEBRIDGE_RAY_TARGET {
    if (!meetings.meet(dx, dy, best)) {
      for (std::size_t k = 0; k < meetings.list.size; ++k) {
        const Segment& wall = segments[walls.indices[begin + meetings.wall_of(k)]];
        const std::size_t first = meetings.ray_of(k);
        for (std::size_t ray = first; ray < first + kLanes; ++ray) {
          const Vec2 direction{dx[ray], dy[ray]};
          if (std::fabs(cross(direction, wall.u)) < kParallel) {
            best[ray] = nearer_hit(wall, origin_, direction, best[ray]);
          }
        }
      }
    }
    meetings.list.size = 0;
  };
  std::int32_t starts[kFloats];
  std::int32_t counts[kFloats];
  for (std::size_t k = 0; k < walls.indices.size(); k += kFloats) {
    if (k - begin == WallMeetings::kWalls) {
      meet_listed();
      begin = k;
    }
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
    const FloatBits beside = (first > last_ray) & (last < period);
    const FloatBits one_run = (first >= 0.0F) & (last < period) & ~beside;
    // Whole registers of rays. The margin is more than a ray that lies at `first`; where no ray is
    // between the two, mostly none.
    constexpr auto kWhole = static_cast<std::int32_t>(kLanes);
    const FloatBits start = whole(first + 1.0F) & -kWhole & one_run;
    const FloatBits end = (whole(smaller(last, Floats{} + last_ray)) + kWhole) & one_run;
    const FloatBits count = (end - start) >> std::countr_zero(kLanes);
    std::memcpy(starts, &start, sizeof starts);
    std::memcpy(counts, &count, sizeof counts);
    const std::size_t rest = walls.indices.size() - k;
    const std::size_t here = rest < kFloats ? rest : kFloats;
    const std::size_t slot = k - begin;
    for (std::size_t i = 0; i < here; ++i) {
      meetings.walls[slot + i] = seen(segments[walls.indices[k + i]], origin_);
      meetings.add(slot + i, static_cast<std::size_t>(starts[i]),
                   static_cast<std::size_t>(counts[i]), meet_listed);
    }
    unsigned others = bits_of(~(one_run | beside)) & ((1U << here) - 1U);
    for (; others != 0; others &= others - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(others));
      each_between(first[i], last[i], [&](std::size_t from, std::size_t to) EYEBRIDGE_RAY_TARGET {
        meetings.add(slot + i, from / kLanes * kLanes, to / kLanes - from / kLanes + 1,
                     meet_listed);
      });
    }
  }
  meet_listed();
}
