// Numbers in registers, by Highway. Each of the *.ipp here is included by sources that
// foreach_target.h compiles once per instruction set, inside of the namespace of that set.
// Never MulAdd(): it rounds once where there is FMA, twice elsewhere; ranges are the same bits.

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::ScalableTag<double> kDouble;
constexpr hn::Repartition<float, decltype(kDouble)> kFloat;
constexpr hn::RebindToSigned<decltype(kFloat)> kInt;
constexpr hn::RebindToUnsigned<decltype(kFloat)> kUnsigned;
constexpr std::size_t kLanes = hn::MaxLanes(kDouble);
constexpr std::size_t kFloats = hn::MaxLanes(kFloat);

using Doubles = hn::Vec<decltype(kDouble)>;
using Floats = hn::Vec<decltype(kFloat)>;
using Ints = hn::Vec<decltype(kInt)>;
using DoubleMask = hn::Mask<decltype(kDouble)>;
using FloatMask = hn::Mask<decltype(kFloat)>;

HWY_INLINE Doubles filled(double value) { return hn::Set(kDouble, value); }
HWY_INLINE Floats filled(float value) { return hn::Set(kFloat, value); }
HWY_INLINE Doubles load(const double* from) { return hn::LoadU(kDouble, from); }
HWY_INLINE Floats load(const float* from) { return hn::LoadU(kFloat, from); }

/// Bit i is set when lane i is.
HWY_INLINE std::uint32_t bits_of(FloatMask mask) {
  std::uint8_t bits[8];
  hn::StoreMaskBits(kFloat, mask, bits);
  return bits[0];
}

/// A place or a direction in each lane.
struct Points {
  Doubles x, y;
};

/// The two doubles at get(i), and after it, in lane i.
template <class Get>
HWY_INLINE Points points_at(Get get) {
  constexpr hn::Full128<double> kPair;
  const auto pair = [&](std::size_t i) HWY_ATTR { return hn::LoadU(kPair, get(i)); };
  if constexpr (kLanes == 2) {
    return {hn::InterleaveLower(kDouble, pair(0), pair(1)),
            hn::InterleaveUpper(kDouble, pair(0), pair(1))};
  } else {
    const Doubles even = hn::Combine(kDouble, pair(2), pair(0));
    const Doubles odd = hn::Combine(kDouble, pair(3), pair(1));
    return {hn::InterleaveLower(kDouble, even, odd), hn::InterleaveUpper(kDouble, even, odd)};
  }
}

/// 1 by the root; relative error below 4e-4, depends on the CPU.
HWY_INLINE Floats inverse_root_of(Floats square) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_EMU128
  return hn::ApproximateReciprocalSqrt(square);
#else
  return filled(1.0F) / hn::Sqrt(square);
#endif
}

/// A wall seen from where rays begin, or one in each lane.
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
HWY_INLINE SeenWalls<Doubles> filled(const SeenWall& wall) {
  return {filled(wall.wx), filled(wall.wy),     filled(wall.ux),
          filled(wall.uy), filled(wall.length), filled(wall.along)};
}

/// How walls meet a register of rays.
struct WallHits {
  DoubleMask hit;
  Doubles along_ray, den;  ///< The range is the one by the other.
  DoubleMask parallel;     ///< Maybe; such rays are not hit.
};

/// As nearer_hit() does: the same operations on the same numbers.
HWY_INLINE WallHits hits_of(const SeenWalls<Doubles>& wall, Doubles dx, Doubles dy) {
  const Doubles signed_den = dx * wall.uy - dy * wall.ux;
  const Doubles sign = hn::And(signed_den, hn::SignBit(kDouble));
  const Doubles den = hn::Abs(signed_den);
  const Doubles along_ray = hn::Xor(wall.along, sign);
  const Doubles along_wall = hn::Xor(wall.wx * dy - wall.wy * dx, sign);
  const Doubles slack = filled(kRayTolerance) * den;
  const Doubles behind = hn::Neg(slack);
  const DoubleMask parallel = den < filled(kParallel);
  const DoubleMask on_wall = hn::And(along_wall >= behind, along_wall <= wall.length * den + slack);
  return {hn::AndNot(parallel, hn::And(on_wall, along_ray >= behind)), along_ray, den, parallel};
}
