#include "fan.hpp"

#if defined(__x86_64__)

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#include <immintrin.h>

#include "fan_pairs.hpp"

// Without fma: the same roundings as everywhere else.
#define EYEBRIDGE_RAY_TARGET __attribute__((target("avx2,bmi,popcnt")))
#define EYEBRIDGE_RAY_LANES 4
#define EYEBRIDGE_OF(name) name##_avx2

namespace eyebridge::world {

#include "fan_discs.ipp"
#include "fan_walls.ipp"

}  // namespace eyebridge::world

#else

#include <cassert>

namespace eyebridge::world {

void Fan::meet_walls_avx2(const Segment*, const WallList&) {
  assert(false && "RayGrid::has_avx2() is false here");
}
void Fan::meet_discs_avx2(std::span<Fan>, const BodyMap&, double) {
  assert(false && "RayGrid::has_avx2() is false here");
}

}  // namespace eyebridge::world

#endif
