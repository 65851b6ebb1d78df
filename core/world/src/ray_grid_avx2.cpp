#include "ray_grid.hpp"
#include "ray_query.hpp"

#if defined(__x86_64__)

#include <cmath>

#include <immintrin.h>

// Without fma: the same roundings as everywhere else.
#define EYEBRIDGE_RAY_TARGET __attribute__((target("avx2")))
#define EYEBRIDGE_RAY_CAST cast_avx2

namespace eyebridge::world {
namespace {

EYEBRIDGE_RAY_TARGET inline unsigned candidates_in(const RayBlock& block, const RayQuery& q) {
  const __m256 ux = _mm256_load_ps(block.ux);
  const __m256 uy = _mm256_load_ps(block.uy);
  const __m256 wx = _mm256_sub_ps(_mm256_load_ps(block.ax), _mm256_set1_ps(q.x));
  const __m256 wy = _mm256_sub_ps(_mm256_load_ps(block.ay), _mm256_set1_ps(q.y));
  const __m256 dx = _mm256_set1_ps(q.dx);
  const __m256 dy = _mm256_set1_ps(q.dy);
  const __m256 den = _mm256_sub_ps(_mm256_mul_ps(dx, uy), _mm256_mul_ps(dy, ux));
  const __m256 along_ray = _mm256_sub_ps(_mm256_mul_ps(wx, uy), _mm256_mul_ps(wy, ux));
  const __m256 along_wall = _mm256_sub_ps(_mm256_mul_ps(wx, dy), _mm256_mul_ps(wy, dx));
  const __m256 sign = _mm256_and_ps(den, _mm256_set1_ps(-0.0F));
  const __m256 size = _mm256_xor_ps(den, sign);
  const __m256 r = _mm256_xor_ps(along_ray, sign);
  const __m256 w = _mm256_xor_ps(along_wall, sign);
  const __m256 margin = _mm256_set1_ps(q.margin);
  const __m256 least = _mm256_set1_ps(-q.margin);
  const __m256 reach = _mm256_set1_ps(q.reach);
  const __m256 length = _mm256_load_ps(block.length);
  const __m256 r_max = _mm256_add_ps(_mm256_mul_ps(reach, size), margin);
  const __m256 w_max = _mm256_add_ps(_mm256_mul_ps(length, size), margin);
  const __m256 hit = _mm256_and_ps(
      _mm256_and_ps(_mm256_cmp_ps(r, least, _CMP_GE_OQ), _mm256_cmp_ps(r, r_max, _CMP_LE_OQ)),
      _mm256_and_ps(_mm256_cmp_ps(w, least, _CMP_GE_OQ), _mm256_cmp_ps(w, w_max, _CMP_LE_OQ)));
  return static_cast<unsigned>(_mm256_movemask_ps(hit));
}

}  // namespace

#include "ray_walk.ipp"

bool RayGrid::has_avx2() { return __builtin_cpu_supports("avx2") != 0; }

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
