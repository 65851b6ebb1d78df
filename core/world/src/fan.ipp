// How the rays of a Fan meet walls and discs. Included by one source per instruction set; it has
// defined EYEBRIDGE_OF(name), what a member function of that name is called there, and what
// ray_lanes.ipp asks for.

#include "disc_lanes.ipp"
#include "wall_lanes.ipp"

namespace {

EYEBRIDGE_RAY_TARGET inline FloatBits sign_of(Floats v) {
  return (FloatBits)v & std::numeric_limits<std::int32_t>::min();
}
EYEBRIDGE_RAY_TARGET inline Floats turned(Floats v, FloatBits sign) {
  return (Floats)((FloatBits)v ^ sign);
}

}  // namespace

/// A word of Pairs: which lanes of meets(ray) are set.
template <class Meets>
EYEBRIDGE_RAY_TARGET inline std::uint64_t Fan::EYEBRIDGE_OF(word)(std::size_t octet,
                                                                  Meets meets) const {
  const std::size_t first = octet * Pairs::kRays;
  const auto bits = [&](std::size_t i) EYEBRIDGE_RAY_TARGET {
    return std::uint64_t{bits_of(meets(first + i))} << (i * Pairs::kLanes);
  };
  const std::uint64_t word = bits(0) | bits(1) | bits(2) | bits(3);
  if (first + 4 >= directions_.size()) return word;
  return word | bits(4) | bits(5) | bits(6) | bits(7);
}

EYEBRIDGE_RAY_TARGET
void Fan::EYEBRIDGE_OF(meet_walls)(const Segment* segments, const WallList& walls) {
  const std::size_t count = directions_.size();
  const auto error = static_cast<float>(walls.error);
  const bool both_ways = 2 * lines_ == count && lines_ <= 4;
  Pairs pairs;
  for (std::size_t k = 0; k < walls.indices.size(); k += kFloats) {
    const Ends ends = ends_of(walls, k, origin_);
    // Turned so that b is to the left of a.
    const FloatBits sign = sign_of(ends.area);
    const Floats ax = turned(ends.ax, sign);
    const Floats ay = turned(ends.ay, sign);
    const Floats bx = turned(ends.bx, sign);
    const Floats by = turned(ends.by, sign);
    const auto left_of_a = [&](std::size_t ray)
                               EYEBRIDGE_RAY_TARGET { return ax * y_[ray] - ay * x_[ray]; };
    const auto left_of_b = [&](std::size_t ray)
                               EYEBRIDGE_RAY_TARGET { return bx * y_[ray] - by * x_[ray]; };
    for (std::size_t octet = 0; octet * Pairs::kRays < count; ++octet) {
      std::uint64_t word = 0;
      if (both_ways) {
        // Rays that look the other way have both ends on the other sides.
        std::uint64_t back = 0;
        for (std::size_t i = 0; i < 4; ++i) {
          const Floats a = left_of_a(i);
          const Floats b = left_of_b(i);
          word |= std::uint64_t{bits_of((a >= -error) & (b <= error))} << (i * Pairs::kLanes);
          back |= std::uint64_t{bits_of((a <= error) & (b >= -error))} << (i * Pairs::kLanes);
        }
        // There may be fewer lines than four.
        word &= (std::uint64_t{1} << (lines_ * Pairs::kLanes)) - 1;
        word |= back << (lines_ * Pairs::kLanes);
      } else {
        word = EYEBRIDGE_OF(word)(octet, [&](std::size_t ray) EYEBRIDGE_RAY_TARGET {
          return (left_of_a(ray) >= -error) & (left_of_b(ray) <= error);
        });
      }
      if (bits_of(ends.along) != 0) [[unlikely]] {
        for (std::size_t i = 0; i < Pairs::kRays; ++i) {
          word |= std::uint64_t{bits_of(ends.along)} << (i * Pairs::kLanes);
        }
      }
      const std::size_t rest = count - octet * Pairs::kRays;
      if (rest < Pairs::kRays) word &= (std::uint64_t{1} << (rest * Pairs::kLanes)) - 1;
      if (pairs.is_full()) [[unlikely]] {
        EYEBRIDGE_OF(meet)(segments, walls.indices.data(), pairs);
      }
      pairs.add(word, k, octet);
    }
  }
  if (pairs.size() != 0) EYEBRIDGE_OF(meet)(segments, walls.indices.data(), pairs);
}

/// nearer_hit() of the pairs: the same operations on the same numbers.
EYEBRIDGE_RAY_TARGET
void Fan::EYEBRIDGE_OF(meet)(const Segment* segments, const std::uint32_t* indices, Pairs& pairs) {
  const LaneBits sign_bit = LaneBits{} + std::numeric_limits<std::int64_t>::min();
  const Lanes zero{};
  const Lanes never = zero + std::numeric_limits<double>::infinity();
  pairs.fill_up(kLanes);
  for (std::size_t k = 0; k < pairs.size(); k += kLanes) {
    const auto wall = [&](std::size_t lane) -> const Segment& {
      return segments[indices[pairs.thing(k + lane)]];
    };
    const auto ray = [&](std::size_t lane) { return directions_[pairs.ray(k + lane)]; };
    const Lanes wx = lanes_of([&](std::size_t i) { return wall(i).a.x; }) - origin_.x;
    const Lanes wy = lanes_of([&](std::size_t i) { return wall(i).a.y; }) - origin_.y;
    const Lanes ux = lanes_of([&](std::size_t i) { return wall(i).u.x; });
    const Lanes uy = lanes_of([&](std::size_t i) { return wall(i).u.y; });
    const Lanes length = lanes_of([&](std::size_t i) { return wall(i).length; });
    const Lanes dx = lanes_of([&](std::size_t i) { return ray(i).x; });
    const Lanes dy = lanes_of([&](std::size_t i) { return ray(i).y; });
    const LaneBits signed_den = (LaneBits)(dx * uy - dy * ux);
    const LaneBits sign = signed_den & sign_bit;
    const Lanes den = (Lanes)(signed_den ^ sign);
    const Lanes along_ray = (Lanes)((LaneBits)(wx * uy - wy * ux) ^ sign);
    const Lanes along_wall = (Lanes)((LaneBits)(wx * dy - wy * dx) ^ sign);
    const Lanes slack = kRayTolerance * den;
    const LaneBits parallel = den < kParallel;
    const LaneBits hit = (along_wall >= -slack) & (along_wall <= length * den + slack) &
                         (along_ray >= -slack) & ~parallel;
    const Lanes along = along_ray / den;
    const Lanes range = hit ? (along > zero ? along : zero) : never;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      double& best = best_[pairs.ray(k + lane)];
      best = range[lane] < best ? range[lane] : best;
    }
    if (!any(parallel)) [[likely]] {
      continue;
    }
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      double& best = best_[pairs.ray(k + lane)];
      best = nearer_hit(wall(lane), origin_, ray(lane), best);
    }
  }
  pairs.clear();
}

/// Which of the registers of `rows` that begin at `starts` hold discs near a line; a byte each.
EYEBRIDGE_RAY_TARGET
inline void Fan::EYEBRIDGE_OF(look)(const BodyMap::Rows& rows,
                                    std::span<const std::uint32_t> starts,
                                    std::uint8_t* near) const {
  const Floats x0 = Floats{} + static_cast<float>(origin_.x);
  const Floats y0 = Floats{} + static_cast<float>(origin_.y);
  const Floats error = Floats{} + static_cast<float>(rows.error);
  const Floats line_x[] = {Floats{} + x_[0], Floats{} + x_[1], Floats{} + x_[2], Floats{} + x_[3]};
  const Floats line_y[] = {Floats{} + y_[0], Floats{} + y_[1], Floats{} + y_[2], Floats{} + y_[3]};
  for (std::size_t n = 0; n < starts.size(); ++n) {
    const Floats x = x0 - load(rows.x + starts[n]);
    const Floats y = y0 - load(rows.y + starts[n]);
    const auto to_line = [&](std::size_t i) EYEBRIDGE_RAY_TARGET {
      return magnitude(x * line_y[i] - y * line_x[i]);
    };
    // What is no number, as there is no such line, comes first, and the other one is smaller.
    Floats across = smaller(smaller(to_line(3), to_line(2)), smaller(to_line(1), to_line(0)));
    for (std::size_t i = 4; i < lines_; ++i) {
      across = smaller(magnitude(x * y_[i] - y * x_[i]), across);
    }
    near[n] = static_cast<std::uint8_t>(bits_of(across <= load(rows.radius + starts[n]) + error));
  }
}

EYEBRIDGE_RAY_TARGET
void Fan::EYEBRIDGE_OF(meet_discs)(const BodyMap& map, double largest_radius) {
  const BodyMap::Rows rows = map.rows(origin_);
  each_register(
      map, rows,
      [&]() EYEBRIDGE_RAY_TARGET {
        return extent_of(origin_, dx_, dy_, best_, directions_.size(),
                         largest_radius + kExtentMargin);
      },
      [&](const std::uint32_t* starts, std::size_t size) EYEBRIDGE_RAY_TARGET {
        EYEBRIDGE_OF(look_at)(rows, {starts, size});
      });
}

/// Shortens the rays that meet discs of the registers that begin at `starts`.
EYEBRIDGE_RAY_TARGET
void Fan::EYEBRIDGE_OF(look_at)(const BodyMap::Rows& rows, std::span<const std::uint32_t> starts) {
  LaneMarks near(starts.size());
  EYEBRIDGE_OF(look)(rows, starts, near.bytes);
  near.each(starts.size(), [&](std::size_t n, std::size_t lane) EYEBRIDGE_RAY_TARGET {
    EYEBRIDGE_OF(meet)(rows.discs[starts[n] + lane]);
  });
}

/// nearer_disc_hit() of all rays: the same operations on the same numbers.
EYEBRIDGE_RAY_TARGET
inline void Fan::EYEBRIDGE_OF(meet)(const Disc& disc) {
  const double wx = disc.x - origin_.x;
  const double wy = disc.y - origin_.y;
  const double radius_squared = disc.radius * disc.radius;
  const Lanes zero{};
  const LaneBits inside = zero + (wx * wx + wy * wy - radius_squared) <= zero;
  for (std::size_t i = 0; i < directions_.size(); i += kLanes) {
    Lanes dx;
    Lanes dy;
    Lanes best;
    load(dx, dx_ + i);
    load(dy, dy_ + i);
    load(best, best_ + i);
    const Lanes along = wx * dx + wy * dy;
    const Lanes across = dx * wy - dy * wx;
    const Lanes half_chord_squared = radius_squared - across * across;
    const LaneBits hit = ((along > zero) & (half_chord_squared >= zero)) | inside;
    const Lanes range = inside ? zero : along - root_of(half_chord_squared);
    best = (hit & (range < best)) ? range : best;
    std::memcpy(best_ + i, &best, sizeof best);
  }
}
