// The walk of a fan of rays through a RayGrid. Included by one source per instruction set, after
// ray_lanes.ipp; it has defined EYEBRIDGE_RAY_CAST, the name of the member function, too.

namespace {

/// Neighbours of a fan, and the ranges found so far.
struct Rays {
  alignas(64) double dx[RayGrid::kChunk];
  alignas(64) double dy[RayGrid::kChunk];
  alignas(64) double best[RayGrid::kChunk];
};

/// nearer_hit() of `wall` for at least the rays `first` to `last`: the same operations on the same
/// numbers. False when one may be parallel to the wall: such rays are left as they are. `rays` are
/// filled up to a whole register.
EYEBRIDGE_RAY_TARGET inline bool meet(const Segment& wall, Vec2 origin, Rays& rays,
                                      std::size_t first, std::size_t last) {
  const SeenWall seen_wall = seen(wall, origin);
  LaneBits parallel{};
  for (std::size_t i = first / kLanes * kLanes; i <= last; i += kLanes) {
    Lanes dx;
    Lanes dy;
    load(dx, rays.dx + i);
    load(dy, rays.dy + i);
    const WallHits hits = hits_of(seen_wall, dx, dy);
    parallel |= hits.parallel;
    Lanes best;
    load(best, rays.best + i);
    // Most are missed, or hidden by something nearer: no division for them. The factor is above the
    // roundings.
    const LaneBits hit = hits.hit & (hits.along_ray <= best * hits.den * (1.0 + 1e-15));
    if (!any(hit)) continue;
    const Lanes range = hits.along_ray / hits.den;
    best = (hit & (range < best)) ? larger(range, Lanes{}) : best;
    std::memcpy(rays.best + i, &best, sizeof best);
  }
  return !any(parallel);
}

}  // namespace

EYEBRIDGE_RAY_TARGET
void RayGrid::EYEBRIDGE_RAY_CAST(Vec2 origin, std::span<const Vec2> directions, double max_range,
                                 std::span<double> ranges) const {
  // All rays go one cell ahead, then all that are left another one, and so on. Nobody can foresee
  // in which cell a ray ends, and a processor that guesses wrong at the end of each ray waits for
  // longer than the ray takes; here that is data, not a branch. And neighbours are in one cell
  // mostly, so that a wall is fetched for all of them and several fill a register.
  RayState states[kChunk];
  std::uint32_t active[kChunk];
  Rays rays;
  double* const best = rays.best;

  for (std::size_t first = 0; first < directions.size(); first += kChunk) {
    const std::size_t rest = directions.size() - first;
    const std::size_t chunk = rest < kChunk ? rest : kChunk;
    const Vec2* const d = directions.data() + first;
    for (std::size_t i = 0; i < chunk; ++i) {
      rays.dx[i] = d[i].x;
      rays.dy[i] = d[i].y;
      best[i] = max_range;
    }
    for (std::size_t i = chunk; i % kLanes != 0; ++i) {  // the last register is full, too
      rays.dx[i] = d[0].x;
      rays.dy[i] = d[0].y;
      best[i] = max_range;
    }
    std::size_t left = start_rays(origin, {d, chunk}, max_range, states, active);
    while (left != 0) {
      for (std::size_t k = 0; k < left;) {
        const std::size_t cell = states[active[k]].cell;
        const std::size_t run = active[k];
        std::size_t end = run;
        // Those between that have ended meet the walls again, for nothing but at no harm.
        for (; k < left && states[active[k]].cell == cell && active[k] - end <= kMaxGap; ++k) {
          end = active[k];
        }
        const Segment* const last = segments_.data() + starts_[cell + 1];
        for (const Segment* wall = segments_.data() + starts_[cell]; wall != last; ++wall) {
          if (meet(*wall, origin, rays, run, end)) continue;
          for (std::size_t i = run; i <= end; ++i) {
            if (std::fabs(cross(d[i], wall->u)) < kParallel) {
              best[i] = nearer_hit(*wall, origin, d[i], best[i]);
            }
          }
        }
      }
      std::size_t on = 0;
      for (std::size_t k = 0; k < left; ++k) {
        const std::uint32_t ray = active[k];
        RayState& state = states[ray];
        // An index, where the compiler would make a branch of a condition.
        const std::size_t axis = state.next[0] < state.next[1] ? 0 : 1;
        const double border = state.next[axis];
        active[on] = ray;
        // A hit in a later cell cannot be nearer than the border to it. Also ends on NaN.
        on += static_cast<std::size_t>((border < best[ray]) & (border < state.limit));
        state.cell += state.step[axis];
        state.next[axis] = border + state.between[axis];
      }
      left = on;
    }
    for (std::size_t i = 0; i < chunk; ++i) ranges[first + i] = best[i];
  }
}
