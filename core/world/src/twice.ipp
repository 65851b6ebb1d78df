// Two registers of floats that go the same way, step by step. Included by one source per
// instruction set, as ray_lanes.ipp is.
//
// A processor looks no farther ahead than one long chain of operations that wait for each other:
// where two such chains alternate, neither holds up the other.

#ifndef EYEBRIDGE_TWICE_IPP
#define EYEBRIDGE_TWICE_IPP

#include "ray_lanes.ipp"

namespace {

struct Twice {
  Floats one, other;
};
struct TwiceBits {
  FloatBits one, other;
};

#define EYEBRIDGE_TWICE(op)                                         \
  EYEBRIDGE_RAY_TARGET inline Twice operator op(Twice a, Twice b) { \
    return {a.one op b.one, a.other op b.other};                    \
  }                                                                 \
  EYEBRIDGE_RAY_TARGET inline Twice operator op(Twice a, float b) { \
    return {a.one op b, a.other op b};                              \
  }                                                                 \
  EYEBRIDGE_RAY_TARGET inline Twice operator op(float a, Twice b) { \
    return {a op b.one, a op b.other};                              \
  }
EYEBRIDGE_TWICE(+)
EYEBRIDGE_TWICE(-)
EYEBRIDGE_TWICE(*)
#undef EYEBRIDGE_TWICE

#define EYEBRIDGE_TWICE(op)                                             \
  EYEBRIDGE_RAY_TARGET inline TwiceBits operator op(Twice a, Twice b) { \
    return {a.one op b.one, a.other op b.other};                        \
  }                                                                     \
  EYEBRIDGE_RAY_TARGET inline TwiceBits operator op(Twice a, float b) { \
    return {a.one op b, a.other op b};                                  \
  }
EYEBRIDGE_TWICE(<)
EYEBRIDGE_TWICE(<=)
EYEBRIDGE_TWICE(>)
EYEBRIDGE_TWICE(>=)
#undef EYEBRIDGE_TWICE

EYEBRIDGE_RAY_TARGET inline TwiceBits operator&(TwiceBits a, TwiceBits b) {
  return {a.one & b.one, a.other & b.other};
}
EYEBRIDGE_RAY_TARGET inline TwiceBits operator|(TwiceBits a, TwiceBits b) {
  return {a.one | b.one, a.other | b.other};
}
EYEBRIDGE_RAY_TARGET inline TwiceBits operator~(TwiceBits a) { return {~a.one, ~a.other}; }

EYEBRIDGE_RAY_TARGET inline Twice magnitude(Twice v) {
  return {magnitude(v.one), magnitude(v.other)};
}
EYEBRIDGE_RAY_TARGET inline Twice smaller(Twice a, Twice b) {
  return {smaller(a.one, b.one), smaller(a.other, b.other)};
}
EYEBRIDGE_RAY_TARGET inline Twice larger(Twice a, Twice b) {
  return {larger(a.one, b.one), larger(a.other, b.other)};
}
EYEBRIDGE_RAY_TARGET inline Twice inverse_root_of(Twice square) {
  return {inverse_root_of(square.one), inverse_root_of(square.other)};
}

EYEBRIDGE_RAY_TARGET inline Floats either(FloatBits first, Floats a, Floats b) {
  return first ? a : b;
}
EYEBRIDGE_RAY_TARGET inline Twice either(TwiceBits first, Twice a, Twice b) {
  return {either(first.one, a.one, b.one), either(first.other, a.other, b.other)};
}

/// Without what is behind the point.
EYEBRIDGE_RAY_TARGET inline FloatBits whole(Floats v) {
  return __builtin_convertvector(v, FloatBits);
}
EYEBRIDGE_RAY_TARGET inline TwiceBits whole(Twice v) { return {whole(v.one), whole(v.other)}; }

EYEBRIDGE_RAY_TARGET inline Twice picked(const float* from, TwiceBits index) {
  return {picked(from, index.one), picked(from, index.other)};
}

EYEBRIDGE_RAY_TARGET inline Twice load_twice(const float* from, std::size_t one,
                                             std::size_t other) {
  return {load(from + one), load(from + other)};
}
EYEBRIDGE_RAY_TARGET inline void store(std::int32_t* to, TwiceBits v) {
  std::memcpy(to, &v.one, sizeof v.one);
  std::memcpy(to + kFloats, &v.other, sizeof v.other);
}

}  // namespace

#endif
