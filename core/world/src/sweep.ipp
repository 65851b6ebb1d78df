// How the rays of a Sweep meet walls and discs. Included by one source per instruction set, after
// ray_lanes.ipp; it has defined EYEBRIDGE_MEET_WALLS and EYEBRIDGE_MEET_DISCS,
// EYEBRIDGE_MEET_ROWS, the names of the
// member functions, too.

namespace {

/// False when all of the first `count` rays surely pass `wall`.
template <class Rays>
EYEBRIDGE_RAY_TARGET inline bool may_meet(const Segment& wall, Vec2 origin, const Rays& rays,
                                          std::size_t count) {
  constexpr double kPass =
      1e-6;  // metres by which the ends are passed, far more than the tolerance
  const Vec2 a = wall.a - origin;
  const Vec2 b = a + wall.length * wall.u;
  const double side = cross(a, wall.u);
  // Counter-clockwise from a to b; else the other way round.
  const Lanes zero{};
  const LaneBits sign = (LaneBits)(zero + side) & std::numeric_limits<std::int64_t>::min();
  // From so near the wall's line the tolerances of rays are wide angles.
  LaneBits between = zero + std::fabs(side) < kNear;
  for (std::size_t i = 0; i < count; i += kLanes) {
    Lanes x;
    Lanes y;
    load(x, rays.dx + i);
    load(y, rays.dy + i);
    const Lanes left_of_a = (Lanes)((LaneBits)(a.x * y - a.y * x) ^ sign);
    const Lanes left_of_b = (Lanes)((LaneBits)(b.x * y - b.y * x) ^ sign);
    between |= (left_of_a >= -kPass) & (left_of_b <= kPass);
  }
  return any(between);
}

}  // namespace

EYEBRIDGE_RAY_TARGET
void Sweep::EYEBRIDGE_MEET_WALLS(const Segment* segments, std::span<const std::uint32_t> walls) {
  const auto meet_rays = [this](const Segment& wall, std::size_t first, std::size_t last)
                             EYEBRIDGE_RAY_TARGET {
                               if (meet(wall, origin_, *this, first, last)) return;
                               for (std::size_t i = first; i <= last; ++i) {
                                 const Vec2 direction{dx[i], dy[i]};
                                 if (std::fabs(cross(direction, wall.u)) < kParallel) {
                                   best[i] = nearer_hit(wall, origin_, direction, best[i]);
                                 }
                               }
                             };
  if (per_gap_ == 0.0) {
    // First who is met at all, without a branch that nobody can foresee; then where.
    constexpr std::size_t kTogether = 64;
    std::uint32_t met[kTogether];
    for (; !walls.empty(); walls = walls.subspan(std::min(walls.size(), kTogether))) {
      std::size_t count = 0;
      for (const std::uint32_t index : walls.first(std::min(walls.size(), kTogether))) {
        met[count] = index;
        count += static_cast<std::size_t>(may_meet(segments[index], origin_, *this, count_));
      }
      for (std::size_t i = 0; i < count; ++i) meet_rays(segments[met[i]], 0, count_ - 1);
    }
    return;
  }
  for (const std::uint32_t index : walls) {
    const Segment& wall = segments[index];
    const Vec2 a = wall.a - origin_;
    const Vec2 b = a + wall.length * wall.u;
    const double side = cross(a, wall.u);
    // From so near the wall's line the tolerances of rays are wide angles.
    if (std::fabs(side) < kNear) {
      meet_rays(wall, 0, count_ - 1);
      continue;
    }
    const bool forward = (side > 0.0) == (turn_ > 0.0);
    each_between(bearing_of(forward ? a : b), bearing_of(forward ? b : a), 0.0,
                 [&](std::size_t first, std::size_t last)
                     EYEBRIDGE_RAY_TARGET { meet_rays(wall, first, last); });
  }
}

EYEBRIDGE_RAY_TARGET
void Sweep::EYEBRIDGE_MEET_DISCS(std::span<const Disc> discs, BodyId ignore) {
  for (const Disc& disc : discs) {
    if (disc.id == ignore) continue;
    const Vec2 w = Vec2{disc.x, disc.y} - origin_;
    const double radius = disc.radius;
    const double squared = norm_squared(w);
    const double radius_squared = radius * radius;
    if (squared - radius_squared <= 0.0) {
      for (std::size_t i = 0; i < count_; ++i) best[i] = best[i] > 0.0 ? 0.0 : best[i];
      continue;
    }
    const auto meet_rays = [&](std::size_t first, std::size_t last) EYEBRIDGE_RAY_TARGET {
      for (std::size_t i = first / kLanes * kLanes; i <= last; i += kLanes) {
        Lanes x;
        Lanes y;
        Lanes nearest;
        load(x, dx + i);
        load(y, dy + i);
        load(nearest, best + i);
        const Lanes along = w.x * x + w.y * y;
        const Lanes across = x * w.y - y * w.x;
        const Lanes half_chord_squared = radius_squared - across * across;
        // What a nearer thing hides needs no root.
        const LaneBits hit =
            (along > 0.0) & (half_chord_squared >= 0.0) & (along - radius <= nearest + 1e-6);
        if (!any(hit)) continue;
        const Lanes range = along - root_of(half_chord_squared);
        nearest = (hit & (range < nearest)) ? range : nearest;
        std::memcpy(best + i, &nearest, sizeof nearest);
      }
    };
    if (per_gap_ == 0.0) {
      meet_rays(0, count_ - 1);
      continue;
    }
    // asin(s) <= s + (pi / 2 - 1) s^3: all terms of its series are positive, and equal at 1.
    const double sine = radius / std::sqrt(squared);
    const double half_width = sine + 0.5708 * sine * sine * sine;
    const double bearing = bearing_of(w);
    each_between(bearing, bearing, half_width, meet_rays);
  }
}

EYEBRIDGE_RAY_TARGET
void Sweep::EYEBRIDGE_MEET_ROWS(const BodyMap::Rows& rows, std::size_t begin, std::size_t end,
                                BodyId ignore) {
  const auto x0 = static_cast<float>(origin_.x);
  const auto y0 = static_cast<float>(origin_.y);
  const auto error = static_cast<float>(rows.error);
  float ray_x[kFew];
  float ray_y[kFew];
  float ray_best[kFew];
  for (std::size_t i = 0; i < count_; ++i) {
    ray_x[i] = static_cast<float>(dx[i]);
    ray_y[i] = static_cast<float>(dy[i]);
    ray_best[i] = static_cast<float>(best[i]) + error;
  }
  for (std::size_t k = begin; k < end; k += kFloats) {
    Floats x;
    Floats y;
    Floats reach;
    std::memcpy(&x, rows.x + k, sizeof x);
    std::memcpy(&y, rows.y + k, sizeof y);
    std::memcpy(&reach, rows.radius + k, sizeof reach);
    x -= x0;
    y -= y0;
    reach += error;
    FloatBits met{};
    for (std::size_t i = 0; i < count_; ++i) {
      const Floats across = ray_x[i] * y - ray_y[i] * x;
      const Floats along = ray_x[i] * x + ray_y[i] * y;
      met |= (across <= reach) & (across >= -reach) & (along >= -reach) &
             (along <= ray_best[i] + reach);
    }
    for (unsigned bits = bits_of(met); bits != 0; bits &= bits - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
      // Those after the last one are real ones, too, or lie beyond all of them.
      if (k + lane < end) EYEBRIDGE_MEET_DISCS({rows.discs + k + lane, 1}, ignore);
    }
  }
}
