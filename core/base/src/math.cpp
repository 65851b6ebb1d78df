#include "eyebridge/base/math.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "eyebridge/base/units.hpp"

namespace eyebridge {
namespace {

// Taylor series about 0, enough terms for |x| <= pi/4 in double precision, in Horner form.
double sin_small(double x) {
  const double z = x * x;
  double s = 1.0 / 355687428096000.0;  // 1/17!
  s = s * z - 1.0 / 1307674368000.0;
  s = s * z + 1.0 / 6227020800.0;
  s = s * z - 1.0 / 39916800.0;
  s = s * z + 1.0 / 362880.0;
  s = s * z - 1.0 / 5040.0;
  s = s * z + 1.0 / 120.0;
  s = s * z - 1.0 / 6.0;
  return x + x * (z * s);
}

double cos_small(double x) {
  const double z = x * x;
  double c = 1.0 / 6402373705728000.0;  // 1/18!
  c = c * z - 1.0 / 20922789888000.0;
  c = c * z + 1.0 / 87178291200.0;
  c = c * z - 1.0 / 479001600.0;
  c = c * z + 1.0 / 3628800.0;
  c = c * z - 1.0 / 40320.0;
  c = c * z + 1.0 / 720.0;
  c = c * z - 1.0 / 24.0;
  const double half = 0.5 * z;
  // (1 - half) rounds; the lost part is put back with the small terms.
  const double head = 1.0 - half;
  return head + ((1.0 - head) - half + z * (z * -c));
}

// pi/2 in two pieces (Cody and Waite): k * kHalfPiHigh is exact for k < 2^20.
constexpr double kHalfPiHigh = 1.57079632673412561417e+00;
constexpr double kHalfPiLow = 6.07710050650619224932e-11;

// As far as k * kHalfPiHigh is exact.
constexpr double kReducedExactly = 1e6;

/// `angle` without its whole turns, by how many turns ever; NaN unless finite.
double without_turns(double angle) {
  // IEEE 754 wants it exact, so that it is the same on every machine.
  return std::remainder(angle, 2.0 * kPi);
}

/// Arc tangent of |t| <= tan(pi/16), by its series; in pairs, so that little waits for the one
/// before.
double atan_small(double t) {
  constexpr auto term = [](int n) { return (n % 4 == 1 ? 1.0 : -1.0) / n; };
  const double z = t * t;
  const double z2 = z * z;
  const double z4 = z2 * z2;
  const double low = (term(1) + term(3) * z) + (term(5) + term(7) * z) * z2;
  const double middle = (term(9) + term(11) * z) + (term(13) + term(15) * z) * z2;
  const double high = (term(17) + term(19) * z) + term(21) * z2;
  return t * (low + (middle + high * z4) * z4);
}

/// 1/13!, 1/12!, … 1/0!: terms of e^r for |r| <= ln(2) / 2.
constexpr std::array<double, 14> kExpTerms = [] {
  std::array<double, 14> terms{};
  double factorial = 1.0;  // exact
  for (std::size_t n = 0; n < terms.size(); ++n) {
    terms[terms.size() - 1 - n] = 1.0 / factorial;
    factorial *= static_cast<double>(n + 1);
  }
  return terms;
}();

}  // namespace

SinCos sin_cos(double angle) {
  // Written so that NaN comes here, too.
  if (!(std::abs(angle) <= kReducedExactly)) {
    angle = without_turns(angle);
    if (std::isnan(angle)) return {angle, angle};
  }
  const double k = std::nearbyint(angle * (2.0 / kPi));
  const double x = (angle - k * kHalfPiHigh) - k * kHalfPiLow;
  const double s = sin_small(x);
  const double c = cos_small(x);
  switch (static_cast<long long>(k) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double arc_tan2(double y, double x) {
  if (x == 0.0 && y == 0.0) return 0.0;
  double ax = std::abs(x);
  double ay = std::abs(y);
  if (ax + ay < 0x1p-1000) {  // half of it might be nothing
    ax *= 0x1p100;
    ay *= 0x1p100;
  }
  const bool steep = ay > ax;
  // Halves: their sums cannot overflow.
  const double far = 0.5 * (steep ? ay : ax);
  const double near = 0.5 * (steep ? ax : ay);
  // The angle that is left to the nearest of 0, pi/8 and pi/4 is at most pi/16:
  // tan(a - b) = (tan a - tan b) / (1 + tan a tan b).
  constexpr double kTanPi16 = 0.19891236737965801;
  constexpr double kTanPi8 = 0.41421356237309503;
  constexpr double kTan3Pi16 = 0.66817863791929888;
  double base = 0.0;
  double tan_base = 0.0;
  if (near > kTan3Pi16 * far) {
    base = kPi / 4;
    tan_base = 1.0;
  } else if (near > kTanPi16 * far) {
    base = kPi / 8;
    tan_base = kTanPi8;
  }
  const double rest = (near - tan_base * far) / (far + tan_base * near);
  double angle = base + atan_small(rest);
  if (steep) angle = kPi / 2 - angle;
  if (x < 0.0) angle = kPi - angle;
  return y < 0.0 ? -angle : angle;
}

double log_of(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // exact: 0.5 <= m < 1
  if (m < 0.70710678118654752) {
    m *= 2.0;
    --exponent;
  }
  const double t = (m - 1.0) / (m + 1.0);  // ln m = 2 atanh t, |t| < 0.172
  const double z = t * t;
  double sum = 0.0;
  for (int n = 21; n >= 1; n -= 2) sum = 1.0 / n + z * sum;
  // ln 2 in two pieces, so that exponent * ln 2 keeps its last bits.
  constexpr double kLn2High = 6.93147180369123816490e-01;
  constexpr double kLn2Low = 1.90821492927058770002e-10;
  return exponent * kLn2High + (2.0 * t * sum + exponent * kLn2Low);
}

double exp_of(double x) {
  if (std::isnan(x)) return x;
  // Beyond these the result is 0 or infinite anyway, and the exponent below would not fit.
  const double bounded = std::min(std::max(x, -746.0), 710.0);
  constexpr double kLn2High = 6.93147180369123816490e-01;
  constexpr double kLn2Low = 1.90821492927058770002e-10;
  const double k = std::nearbyint(bounded * (1.0 / (kLn2High + kLn2Low)));
  const double r = (bounded - k * kLn2High) - k * kLn2Low;  // |r| <= ln(2) / 2
  double sum = 0.0;
  for (const double term : kExpTerms) sum = sum * r + term;
  return std::ldexp(sum, static_cast<int>(k));  // exact, but for subnormal results
}

double wrap_angle(double angle) {
  if (angle > -kPi && angle <= kPi) return angle;
  const bool near = std::abs(angle) <= kReducedExactly;
  const double turns = near ? std::floor((angle + kPi) / (2.0 * kPi)) : 0.0;
  double wrapped = near ? angle - turns * (2.0 * kPi) : without_turns(angle);
  if (wrapped <= -kPi) wrapped += 2.0 * kPi;
  if (wrapped > kPi) wrapped -= 2.0 * kPi;
  return wrapped;
}

}  // namespace eyebridge
