// Neighbouring rays in registers. Included by the sources of one instruction set, which have
// defined before:
//   EYEBRIDGE_RAY_TARGET   the attribute of functions of that instruction set, or nothing
//   EYEBRIDGE_RAY_LANES    how many rays fit one register
// Text is shared, not a template, because g++ inlines no function of a richer instruction set into
// one of a poorer, and the linker must not take one for the other.

#ifndef EYEBRIDGE_RAY_LANES_IPP
#define EYEBRIDGE_RAY_LANES_IPP

namespace {

constexpr std::size_t kLanes = EYEBRIDGE_RAY_LANES;
using Lanes = double __attribute__((vector_size(8 * kLanes)));
using LaneBits = std::int64_t __attribute__((vector_size(8 * kLanes)));

constexpr std::size_t kFloats = 2 * kLanes;
using Floats = float __attribute__((vector_size(4 * kFloats)));
using FloatBits = std::int32_t __attribute__((vector_size(4 * kFloats)));

EYEBRIDGE_RAY_TARGET inline Floats magnitude(Floats v) {
  return (Floats)((FloatBits)v & std::numeric_limits<std::int32_t>::max());
}

EYEBRIDGE_RAY_TARGET inline Floats smaller(Floats a, Floats b) {
#if defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 4
  return __builtin_ia32_minps256(a, b);
#elif defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 2
  return __builtin_ia32_minps(a, b);
#else
  return a < b ? a : b;
#endif
}

EYEBRIDGE_RAY_TARGET inline Lanes smaller(Lanes a, Lanes b) {
#if defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 4
  return __builtin_ia32_minpd256(a, b);
#elif defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 2
  return __builtin_ia32_minpd(a, b);
#else
  return a < b ? a : b;
#endif
}

EYEBRIDGE_RAY_TARGET inline Lanes larger(Lanes a, Lanes b) {
#if defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 4
  return __builtin_ia32_maxpd256(a, b);
#elif defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 2
  return __builtin_ia32_maxpd(a, b);
#else
  return a > b ? a : b;
#endif
}

EYEBRIDGE_RAY_TARGET inline Floats larger(Floats a, Floats b) {
#if defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 4
  return __builtin_ia32_maxps256(a, b);
#elif defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 2
  return __builtin_ia32_maxps(a, b);
#else
  return a > b ? a : b;
#endif
}

/// Bit i is set when lane i is.
EYEBRIDGE_RAY_TARGET inline unsigned bits_of(FloatBits mask) {
#if defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 4
  return static_cast<unsigned>(__builtin_ia32_movmskps256((Floats)mask));
#elif defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 2
  return static_cast<unsigned>(__builtin_ia32_movmskps((Floats)mask));
#else
  unsigned bits = 0;
  for (std::size_t lane = 0; lane < kFloats; ++lane) bits |= (mask[lane] != 0 ? 1U : 0U) << lane;
  return bits;
#endif
}

/// get(i) in lane i.
template <class Get>
EYEBRIDGE_RAY_TARGET inline Lanes lanes_of(Get get) {
#if EYEBRIDGE_RAY_LANES == 4
  return Lanes{get(0), get(1), get(2), get(3)};
#else
  return Lanes{get(0), get(1)};
#endif
}
template <class Get>
EYEBRIDGE_RAY_TARGET inline Floats floats_of(Get get) {
#if EYEBRIDGE_RAY_LANES == 4
  return Floats{get(0), get(1), get(2), get(3), get(4), get(5), get(6), get(7)};
#else
  return Floats{get(0), get(1), get(2), get(3)};
#endif
}

/// `value` in each lane.
EYEBRIDGE_RAY_TARGET inline Floats filled(float value) { return value - Floats{}; }

/// from[index] in each lane.
EYEBRIDGE_RAY_TARGET inline Floats picked(const float* from, FloatBits index) {
#if defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 4
  return _mm256_i32gather_ps(from, (__m256i)index, 4);
#else
  return floats_of([&](std::size_t i) { return from[index[i]]; });
#endif
}

EYEBRIDGE_RAY_TARGET inline Floats load(const float* from) {
  Floats floats;
  std::memcpy(&floats, from, sizeof floats);
  return floats;
}

EYEBRIDGE_RAY_TARGET inline void load(Lanes& lanes, const double* from) {
  std::memcpy(&lanes, from, sizeof lanes);
}

/// True when any lane's bits are set; each lane has all of them or none.
EYEBRIDGE_RAY_TARGET inline bool any(LaneBits mask) {
#if defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 4
  return __builtin_ia32_movmskpd256((Lanes)mask) != 0;
#elif defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 2
  return __builtin_ia32_movmskpd((Lanes)mask) != 0;
#else
  std::int64_t bits = 0;
  for (std::size_t lane = 0; lane < kLanes; ++lane) bits |= mask[lane];
  return bits != 0;
#endif
}

EYEBRIDGE_RAY_TARGET inline Lanes root_of(Lanes square) {
#if defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 4
  return __builtin_ia32_sqrtpd256(square);
#elif defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 2
  return __builtin_ia32_sqrtpd(square);
#else
  for (std::size_t lane = 0; lane < kLanes; ++lane) square[lane] = std::sqrt(square[lane]);
  return square;
#endif
}

/// 1 by the root, within a part of 4e-4: not the same on all processors.
EYEBRIDGE_RAY_TARGET inline Floats inverse_root_of(Floats square) {
#if defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 4
  return __builtin_ia32_rsqrtps256(square);
#elif defined(__x86_64__) && EYEBRIDGE_RAY_LANES == 2
  return __builtin_ia32_rsqrtps(square);
#else
  for (std::size_t lane = 0; lane < kFloats; ++lane) square[lane] = 1.0F / std::sqrt(square[lane]);
  return square;
#endif
}

/// A wall, or one in each lane, seen from where rays begin.
template <class Values>
struct SeenWalls {
  Values wx, wy;  ///< From there to its end a.
  Values ux, uy;
  Values length;
  Values along;  ///< Of the cross products w x u.
};
using SeenWall = SeenWalls<double>;
inline SeenWall seen(const Segment& wall, Vec2 origin) {
  const Vec2 w = wall.a - origin;
  return {w.x, w.y, wall.u.x, wall.u.y, wall.length, cross(w, wall.u)};
}

/// How a wall meets a register of rays.
struct WallHits {
  LaneBits hit;
  Lanes along_ray, den;  ///< The range is the one by the other.
  LaneBits parallel;     ///< Maybe; such rays are not hit.
};

/// As nearer_hit() does: the same operations on the same numbers.
template <class Values>
EYEBRIDGE_RAY_TARGET inline WallHits hits_of(const SeenWalls<Values>& wall, Lanes dx, Lanes dy) {
  const LaneBits sign_bit = LaneBits{} + std::numeric_limits<std::int64_t>::min();
  const LaneBits signed_den = (LaneBits)(dx * wall.uy - dy * wall.ux);
  const LaneBits sign = signed_den & sign_bit;
  const Lanes den = (Lanes)(signed_den ^ sign);
  const Lanes along_ray = (Lanes)((LaneBits)(Lanes{} + wall.along) ^ sign);
  const Lanes along_wall = (Lanes)((LaneBits)(wall.wx * dy - wall.wy * dx) ^ sign);
  const Lanes slack = kRayTolerance * den;
  const LaneBits parallel = den < kParallel;
  return {(along_wall >= -slack) & (along_wall <= wall.length * den + slack) &
              (along_ray >= -slack) & ~parallel,
          along_ray, den, parallel};
}

}  // namespace

#endif
