// How the rays of a Sweep meet walls and discs. Included by one source per instruction set, after
// ray_lanes.ipp; it has defined EYEBRIDGE_MEET_WALLS and EYEBRIDGE_MEET_DISCS, the names of the
// member functions, too.

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
    // Counter-clockwise from `right` to `left`.
    const Vec2 right = side > 0.0 ? a : b;
    const Vec2 left = side > 0.0 ? b : a;
    if (per_gap_ != 0.0) {
      const bool clockwise = turn_ < 0.0;
      each_between(bearing_of(clockwise ? left : right), bearing_of(clockwise ? right : left), 0.0,
                   [&](std::size_t first, std::size_t last)
                       EYEBRIDGE_RAY_TARGET { meet_rays(wall, first, last); });
      continue;
    }
    for (std::size_t i = 0; i < count_; i += kLanes) {
      Lanes x;
      Lanes y;
      load(x, dx + i);
      load(y, dy + i);
      // Metres by which the rays pass the ends, far more than their tolerance.
      constexpr double kPass = 1e-6;
      const LaneBits between = (right.x * y - right.y * x >= -kPass) &  //
                               (left.x * y - left.y * x <= kPass);
      if (any(between)) meet_rays(wall, i, std::min(i + kLanes, count_) - 1);
    }
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
