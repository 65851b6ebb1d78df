// How the rays of a Sweep meet walls and discs. Included by one source per instruction set, after
// ray_lanes.ipp; it has defined EYEBRIDGE_MEET_WALLS and EYEBRIDGE_MEET_DISCS,
// EYEBRIDGE_MEET_ROWS, the names of the
// member functions, too.

EYEBRIDGE_RAY_TARGET
void Sweep::EYEBRIDGE_MEET_WALLS(const Segment* segments, const WallList& walls) {
  const auto meet_rays = [this](const Segment& wall, std::size_t first, std::size_t last)
                             EYEBRIDGE_RAY_TARGET {
                               const bool few = count_ <= kFew;
                               if (meet(wall, origin_, *this, first, last, few)) return;
                               for (std::size_t i = first; i <= last; ++i) {
                                 const Vec2 direction{dx[i], dy[i]};
                                 if (std::fabs(cross(direction, wall.u)) < kParallel) {
                                   best[i] = nearer_hit(wall, origin_, direction, best[i]);
                                 }
                               }
                             };
  if (per_gap_ == 0.0 && count_ <= kFew) {
    // First who is met at all, many at once and without branches that nobody can foresee.
    const auto x0 = static_cast<float>(origin_.x - walls.centre.x);
    const auto y0 = static_cast<float>(origin_.y - walls.centre.y);
    const auto error = static_cast<float>(walls.error);
    float ray_x[kFew];
    float ray_y[kFew];
    for (std::size_t i = 0; i < count_; ++i) {
      ray_x[i] = static_cast<float>(dx[i]);
      ray_y[i] = static_cast<float>(dy[i]);
    }
    for (std::size_t k = 0; k < walls.indices.size(); k += kFloats) {
      Floats ax;
      Floats ay;
      Floats bx;
      Floats by;
      std::memcpy(&ax, walls.ends + k, sizeof ax);
      std::memcpy(&ay, walls.ends + walls.stride + k, sizeof ay);
      std::memcpy(&bx, walls.ends + 2 * walls.stride + k, sizeof bx);
      std::memcpy(&by, walls.ends + 3 * walls.stride + k, sizeof by);
      ax -= x0;
      ay -= y0;
      bx -= x0;
      by -= y0;
      // Seen from here b is to the left of a; else the other way round.
      const Floats area = ax * by - ay * bx;
      const FloatBits sign = (FloatBits)area & std::numeric_limits<std::int32_t>::min();
      // From so near the wall's line the tolerances of rays are wide angles: the area by the
      // length.
      const Floats length = magnitude(ax - bx) + magnitude(ay - by);
      const Floats size = (magnitude(ax) + magnitude(ay)) * (magnitude(bx) + magnitude(by));
      FloatBits met = magnitude(area) <= (kNearFloat + 2 * error) * length + 1e-5F * size;
      for (std::size_t i = 0; i < count_; ++i) {
        const Floats left_of_a = (Floats)((FloatBits)(ax * ray_y[i] - ay * ray_x[i]) ^ sign);
        const Floats left_of_b = (Floats)((FloatBits)(bx * ray_y[i] - by * ray_x[i]) ^ sign);
        met |= (left_of_a >= -error) & (left_of_b <= error);
      }
      for (unsigned bits = bits_of(met); bits != 0; bits &= bits - 1) {
        const std::size_t at = k + static_cast<std::size_t>(std::countr_zero(bits));
        if (at >= walls.indices.size()) break;
        meet_rays(segments[walls.indices[at]], 0, count_ - 1);
      }
    }
    return;
  }
  if (per_gap_ == 0.0) {
    for (const std::uint32_t index : walls.indices) meet_rays(segments[index], 0, count_ - 1);
    return;
  }
  for (const std::uint32_t index : walls.indices) {
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
        if (count_ > kFew && !any(hit)) continue;
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
