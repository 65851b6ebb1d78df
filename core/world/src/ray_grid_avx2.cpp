#include "ray_grid.hpp"

#if defined(__x86_64__)

#include <cmath>
#include <cstring>
#include <limits>

#include <immintrin.h>

// Without fma: the same roundings as everywhere else.
#define EYEBRIDGE_RAY_TARGET __attribute__((target("avx2")))
#define EYEBRIDGE_RAY_CAST cast_avx2
#define EYEBRIDGE_RAY_LANES 4

namespace eyebridge::world {

#include "ray_lanes.ipp"
#include "ray_walk.ipp"

bool RayGrid::has_avx2() {
  // All processors with the first have the other one, too; a virtual machine may hide it.
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("bmi") != 0;
}

}  // namespace eyebridge::world

#else

#include <cassert>

namespace eyebridge::world {

void RayGrid::cast_avx2(Vec2, std::span<const Vec2>, double, std::span<double>) const {
  assert(false && "has_avx2() is false here");
}

bool RayGrid::has_avx2() { return false; }

}  // namespace eyebridge::world

#endif
