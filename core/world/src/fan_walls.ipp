// How the rays of a Fan meet walls. Included by one source per instruction set; it has defined
// EYEBRIDGE_OF(name), what a member function of that name is called there, and what ray_lanes.ipp
// asks for.

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
  const auto spread = static_cast<float>(spread_ + 2 * walls.error) + kNear;
  const bool both_ways = 2 * lines_ == count && lines_ <= 4;
  Pairs pairs;
  // `apart`: the rays begin at places of their own.
  const auto find = [&](auto apart) EYEBRIDGE_RAY_TARGET {
    for (std::size_t k = 0; k < walls.indices.size(); k += kFloats) {
      const Ends ends = ends_of(walls, k, origin_);
      // Turned so that b is to the left of a.
      const FloatBits sign = sign_of(ends.area);
      const Floats ax = turned(ends.ax, sign);
      const Floats ay = turned(ends.ay, sign);
      const Floats bx = turned(ends.bx, sign);
      const Floats by = turned(ends.by, sign);
      // A wall's line that goes between them is seen from its other side by some of the rays.
      const FloatBits between =
          apart ? ends.along | (magnitude(ends.area) <= spread * ends.length) : FloatBits{};
      const auto left_of = [&](Floats x, Floats y, std::size_t ray) EYEBRIDGE_RAY_TARGET {
        const Floats left = x * y_[ray] - y * x_[ray];
        if constexpr (apart) {
          return left - turned(filled(beside_[ray]), sign);
        } else {
          return left;
        }
      };
      struct Met {
        FloatBits there, back;
      };
      // By the ray, and by one that looks the other way: it has both ends on the other sides.
      const auto met = [&](std::size_t ray) EYEBRIDGE_RAY_TARGET {
        const Floats a = left_of(ax, ay, ray);
        const Floats b = left_of(bx, by, ray);
        const FloatBits there = (a >= -error) & (b <= error);
        const FloatBits back = (a <= error) & (b >= -error);
        return apart ? Met{there | (back & between), back | (there & between)} : Met{there, back};
      };
      for (std::size_t octet = 0; octet * Pairs::kRays < count; ++octet) {
        std::uint64_t word = 0;
        if (both_ways) {
          std::uint64_t back = 0;
          for (std::size_t i = 0; i < 4; ++i) {
            const Met one = met(i);
            word |= std::uint64_t{bits_of(one.there)} << (i * Pairs::kLanes);
            back |= std::uint64_t{bits_of(one.back)} << (i * Pairs::kLanes);
          }
          // There may be fewer lines than four.
          word &= (std::uint64_t{1} << (lines_ * Pairs::kLanes)) - 1;
          word |= back << (lines_ * Pairs::kLanes);
        } else {
          word = EYEBRIDGE_OF(word)(
              octet, [&](std::size_t ray) EYEBRIDGE_RAY_TARGET { return met(ray).there; });
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
  };
  if (apart_) {
    find(std::true_type{});
  } else {
    find(std::false_type{});
  }
  if (pairs.size() != 0) EYEBRIDGE_OF(meet)(segments, walls.indices.data(), pairs);
}

/// nearer_hit() of the pairs.
EYEBRIDGE_RAY_TARGET
void Fan::EYEBRIDGE_OF(meet)(const Segment* segments, const std::uint32_t* indices, Pairs& pairs) {
  const Lanes never = Lanes{} + std::numeric_limits<double>::infinity();
  pairs.fill_up(kLanes);
  for (std::size_t k = 0; k < pairs.size(); k += kLanes) {
    const auto wall = [&](std::size_t lane) -> const Segment& {
      return segments[indices[pairs.thing(k + lane)]];
    };
    const auto ray = [&](std::size_t lane) { return directions_[pairs.ray(k + lane)]; };
    SeenWalls<Lanes> walls;
    walls.wx = lanes_of([&](std::size_t i) { return wall(i).a.x; });
    walls.wy = lanes_of([&](std::size_t i) { return wall(i).a.y; });
    if (apart_) {
      walls.wx -= lanes_of([&](std::size_t i) { return ox_[pairs.ray(k + i)]; });
      walls.wy -= lanes_of([&](std::size_t i) { return oy_[pairs.ray(k + i)]; });
    } else {
      walls.wx -= origin_.x;
      walls.wy -= origin_.y;
    }
    walls.ux = lanes_of([&](std::size_t i) { return wall(i).u.x; });
    walls.uy = lanes_of([&](std::size_t i) { return wall(i).u.y; });
    walls.length = lanes_of([&](std::size_t i) { return wall(i).length; });
    walls.along = walls.wx * walls.uy - walls.wy * walls.ux;
    const Lanes dx = lanes_of([&](std::size_t i) { return ray(i).x; });
    const Lanes dy = lanes_of([&](std::size_t i) { return ray(i).y; });
    const WallHits hits = hits_of(walls, dx, dy);
    const Lanes range = hits.hit ? larger(hits.along_ray / hits.den, Lanes{}) : never;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      double& best = best_[pairs.ray(k + lane)];
      best = range[lane] < best ? range[lane] : best;
    }
    if (!any(hits.parallel)) [[likely]] {
      continue;
    }
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      double& best = best_[pairs.ray(k + lane)];
      best = nearer_hit(wall(lane), origin_of(pairs.ray(k + lane)), ray(lane), best);
    }
  }
  pairs.clear();
}
