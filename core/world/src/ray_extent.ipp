// How far rays get, all together. Included by one source per instruction set, as ray_lanes.ipp is.

#ifndef EYEBRIDGE_RAY_EXTENT_IPP
#define EYEBRIDGE_RAY_EXTENT_IPP

#include "ray_lanes.ipp"

namespace {

/// No body is farther away than this, metres: infinite ranges need an end.
constexpr double kLongestRay = 1e9;

/// For the rounding of ends of rays, metres.
constexpr double kExtentMargin = 1e-6;

/// How far something reaches from a place: to the left, down, to the right and up, metres, each 0
/// or more.
struct Reaches {
  double most[4];
};

/// The most of each of `left` to `up`, which are 0 or more.
EYEBRIDGE_RAY_TARGET inline Reaches most_of(Lanes left, Lanes down, Lanes right, Lanes up) {
  Reaches reaches{};
#if EYEBRIDGE_RAY_LANES == 4
  const auto pairs = [&](Lanes a, Lanes b) EYEBRIDGE_RAY_TARGET {
    return larger(__builtin_shufflevector(a, b, 0, 4, 2, 6),
                  __builtin_shufflevector(a, b, 1, 5, 3, 7));
  };
  const Lanes a = pairs(left, down);
  const Lanes b = pairs(right, up);
  const Lanes most =
      larger(__builtin_shufflevector(a, b, 0, 1, 4, 5), __builtin_shufflevector(a, b, 2, 3, 6, 7));
  std::memcpy(reaches.most, &most, sizeof most);
#else
  const Lanes all[] = {left, down, right, up};
  for (std::size_t i = 0; i < 4; ++i) {
    reaches.most[i] = all[i][0] > all[i][1] ? all[i][0] : all[i][1];
  }
#endif
  return reaches;
}

/// Of `count` rays that begin at one place, or less than `margin` metres off, and end at `best`;
/// and `margin` metres more. The arrays are filled up to a whole register.
EYEBRIDGE_RAY_TARGET inline Reaches reaches_of(const double* dx, const double* dy,
                                               const double* best, std::size_t count,
                                               double margin) {
  Lanes left[2]{};
  Lanes down[2]{};
  Lanes right[2]{};
  Lanes up[2]{};
  const Lanes longest = Lanes{} + kLongestRay;
  const auto add = [&](std::size_t i, std::size_t to) EYEBRIDGE_RAY_TARGET {
    Lanes x;
    Lanes y;
    Lanes range;
    load(x, dx + i);
    load(y, dy + i);
    load(range, best + i);
    range = smaller(range, longest);
    x *= range;
    y *= range;
    left[to] = larger(-x, left[to]);
    down[to] = larger(-y, down[to]);
    right[to] = larger(x, right[to]);
    up[to] = larger(y, up[to]);
  };
  std::size_t i = 0;
  // In turns: each of them waits for the one before.
  for (; i + kLanes < count; i += 2 * kLanes) {
    add(i, 0);
    add(i + kLanes, 1);
  }
  if (i < count) add(i, 0);
  return most_of(larger(left[0], left[1]) + margin, larger(down[0], down[1]) + margin,
                 larger(right[0], right[1]) + margin, larger(up[0], up[1]) + margin);
}

/// The cells of `map` that hold all discs with centres so far from `origin`, and more.
EYEBRIDGE_RAY_TARGET inline BodyMap::Box box_around(const BodyMap& map, Vec2 origin,
                                                    const Reaches& reaches) {
#if EYEBRIDGE_RAY_LANES == 4
  using Cells = std::int32_t __attribute__((vector_size(16)));
  const BodyMap::Cells cells = map.cells();
  Lanes reach;
  load(reach, reaches.most);
  const Lanes sign = {-1.0, -1.0, 1.0, 1.0};
  const Lanes place = Lanes{origin.x, origin.y, origin.x, origin.y} + sign * reach;
  const Lanes scale = {cells.per_column, cells.per_row, cells.per_column, cells.per_row};
  const Lanes last = {cells.last_column, cells.last_row, cells.last_column, cells.last_row};
  // The first one where the other is no number.
  const Lanes index = smaller(larger(place * scale, Lanes{}), last);
  const Cells box = __builtin_convertvector(index, Cells);
  return {static_cast<std::size_t>(box[0]), static_cast<std::size_t>(box[2]),
          static_cast<std::size_t>(box[1]), static_cast<std::size_t>(box[3])};
#else
  const double* const most = reaches.most;
  return map.box(origin - Vec2{most[0], most[1]}, origin + Vec2{most[2], most[3]});
#endif
}

}  // namespace

#endif
