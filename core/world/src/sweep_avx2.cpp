#include "sweep.hpp"

#if defined(__x86_64__)

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include <immintrin.h>

#include "sweep_bearings.hpp"

// Without fma: the same roundings as everywhere else.
#define EYEBRIDGE_RAY_TARGET __attribute__((target("avx2")))
#define EYEBRIDGE_RAY_LANES 4
#define EYEBRIDGE_OF(name) name##_avx2

namespace eyebridge::world {

#include "sweep_discs.ipp"
#include "sweep_walls.ipp"

}  // namespace eyebridge::world

#else

#include <cassert>

namespace eyebridge::world {

void Sweep::meet_walls_avx2(const Segment*, const WallList&) {
  assert(false && "RayGrid::has_avx2() is false here");
}
void Sweep::meet_discs_avx2(std::span<const Disc>, BodyId) {
  assert(false && "RayGrid::has_avx2() is false here");
}
void Sweep::meet_discs_avx2(const BodyMap&, double) {
  assert(false && "RayGrid::has_avx2() is false here");
}

}  // namespace eyebridge::world

#endif
