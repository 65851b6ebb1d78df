#include <algorithm>
#include <cmath>
#include <cstdint>

#include "eyebridge/base/instruction_sets.hpp"
#include "ray_grid.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ray_walk.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace eyebridge::world::HWY_NAMESPACE {
namespace {

#include "lanes.ipp"

/// Rays farther apart than this are not tried together, even in one cell.
constexpr std::size_t kMaxGap = 8;

/// nearer_hit() of `wall` for at least the rays `first` to `last`: the same operations on the same
/// numbers.
HWY_INLINE void meet(const Segment& wall, Vec2 origin, RayGroup& rays, std::size_t first,
                     std::size_t last) {
  const SeenWalls<Doubles> seen_wall = filled(seen(wall, origin));
  DoubleMask parallel = hn::Zero(kDouble) < hn::Zero(kDouble);
  for (std::size_t i = first / kLanes * kLanes; i <= last; i += kLanes) {
    const WallHits hits = hits_of(seen_wall, load(rays.dx + i), load(rays.dy + i));
    parallel = hn::Or(parallel, hits.parallel);
    const Doubles best = load(rays.best + i);
    // Most are missed, or hidden by something nearer: no division for them. The factor is above the
    // roundings.
    const DoubleMask near = hits.along_ray <= best * hits.den * filled(1.0 + 1e-15);
    const DoubleMask hit = hn::And(hits.hit, near);
    if (hn::AllFalse(kDouble, hit)) continue;
    const Doubles range = hits.along_ray / hits.den;
    const Doubles met = hn::Max(range, hn::Zero(kDouble));
    hn::StoreU(hn::IfThenElse(hn::And(hit, range < best), met, best), kDouble, rays.best + i);
  }
  if (hn::AllFalse(kDouble, parallel)) [[likely]] {
    return;
  }
  for (std::size_t i = first; i <= last; ++i) {
    const Vec2 direction{rays.dx[i], rays.dy[i]};
    if (std::fabs(cross(direction, wall.u)) < kParallel) {
      rays.best[i] = nearer_hit(wall, origin, direction, rays.best[i]);
    }
  }
}

/// Lets each ray that is on its way try the walls of its cell.
HWY_INLINE void meet_cells(Vec2 origin, const Segment* segments, const std::uint32_t* starts,
                           RayGroup& rays) {
  for (std::size_t k = 0; k < rays.left;) {
    const std::size_t first = rays.active[k];
    const std::size_t cell = rays.states[first].cell;
    std::size_t last = first;
    // Those between that have ended meet the walls again, for nothing but at no harm.
    for (; k < rays.left; ++k) {
      const std::size_t next = rays.active[k];
      if (rays.states[next].cell != cell || next - last > kMaxGap) break;
      last = next;
    }
    for (std::uint32_t wall = starts[cell]; wall != starts[cell + 1]; ++wall) {
      meet(segments[wall], origin, rays, first, last);
    }
  }
}

/// Moves a ray to the last cell before it leaves the square of `clear` empty cells on each side of
/// its own.
inline void leap(RayState& ray, std::size_t clear) {
  const double cells = static_cast<double>(clear);
  const double exit[2] = {ray.next[0] + cells * ray.between[0],
                          ray.next[1] + cells * ray.between[1]};
  const std::size_t axis = exit[0] < exit[1] ? 0 : 1;
  const std::size_t other = 1 - axis;
  ray.cell += clear * ray.step[axis];
  ray.next[axis] = exit[axis];
  // Borders of the other axis until then. Rounding makes one more or less of them only where the
  // ray goes through a corner of cells; walls there are listed in all cells around it.
  const double past = exit[axis] - ray.next[other];
  if (!(past > 0.0)) return;
  const double borders = std::min(std::floor(past / ray.between[other]) + 1.0, cells);
  ray.cell += static_cast<std::size_t>(borders) * ray.step[other];
  ray.next[other] += borders * ray.between[other];
}

/// Moves all rays on their way to their next cells, and leaves out those that have ended. `clear`
/// is null where no ray leaps.
HWY_INLINE void go_on(const std::uint8_t* clear, RayGroup& rays) {
  std::size_t on = 0;
  for (std::size_t k = 0; k < rays.left; ++k) {
    const std::uint32_t ray = rays.active[k];
    RayState& state = rays.states[ray];
    if (clear != nullptr && clear[state.cell] >= RayGroup::kLeap) leap(state, clear[state.cell]);
    // An index, where the compiler would make a branch of a condition.
    const std::size_t axis = state.next[0] < state.next[1] ? 0 : 1;
    const double border = state.next[axis];
    rays.active[on] = ray;
    // A hit in a later cell cannot be nearer than the border to it. Also ends on NaN.
    on += static_cast<std::size_t>((border < rays.best[ray]) & (border < state.limit));
    state.cell += state.step[axis];
    state.next[axis] = border + state.between[axis];
  }
  rays.left = on;
}

/// All rays go one cell ahead, then all that are left another one, and so on. Nobody can foresee in
/// which cell a ray ends, and a processor that guesses wrong at the end of each ray waits for
/// longer than the ray takes; here that is data, not a branch. And neighbours are in one cell
/// mostly, so that a wall is fetched for all of them and several fill a register.
void walk(Vec2 origin, const Segment* segments, const std::uint32_t* starts,
          const std::uint8_t* clear, RayGroup& rays) {
  while (rays.left != 0) {
    meet_cells(origin, segments, starts, rays);
    go_on(clear, rays);
  }
}

}  // namespace
}  // namespace eyebridge::world::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyebridge::world {

void RayGrid::walk(Vec2 origin, RayGroup& group) const {
  EYEBRIDGE_BEST(walk)
  (origin, segments_.data(), starts_.data(), clear_.empty() ? nullptr : clear_.data(), group);
}

}  // namespace eyebridge::world
#endif
