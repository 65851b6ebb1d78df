#include "eyebridge/base/normal.hpp"

#include <cmath>

namespace eyebridge {
namespace {

constexpr double kRootOfTwoPi = 2.5066282746310005;
constexpr double kFarOut = 38.5;   // beyond, the density is no normal double any more
constexpr double kTailFrom = 2.5;  // where the series gets long and the fraction short
constexpr int kTailTerms = 64;     // 1e-14 at kTailFrom

/// e to the power of `x`, -750 <= x <= 0.
double power_of_e(double x) {
  // ln 2 in two pieces, as log_of() has it.
  constexpr double kLn2High = 6.93147180369123816490e-01;
  constexpr double kLn2Low = 1.90821492927058770002e-10;
  const double k = std::nearbyint(x / (kLn2High + kLn2Low));
  const double rest = (x - k * kLn2High) - k * kLn2Low;
  double sum = 1.0;
  for (int n = 15; n >= 1; --n) sum = 1.0 + rest / n * sum;
  return std::ldexp(sum, static_cast<int>(k));  // exact, but for what is no normal double
}

/// The probability of more than `x` > 0.
double upper_tail(double x) {
  double fraction = x;
  for (int n = kTailTerms; n >= 1; --n) fraction = x + n / fraction;
  return normal_density(x) / fraction;
}

}  // namespace

double normal_density(double x) {
  if (!(std::abs(x) <= kFarOut)) return std::isnan(x) ? x : 0.0;
  return power_of_e(-0.5 * x * x) / kRootOfTwoPi;
}

double normal_below(double x) {
  if (x < -kFarOut) return 0.0;
  if (x > kFarOut) return 1.0;
  if (x < -kTailFrom) return upper_tail(-x);
  if (x > kTailFrom) return 1.0 - upper_tail(x);
  double term = x;
  double sum = x;
  for (int n = 3; std::abs(term) > 1e-17 * std::abs(sum); n += 2) sum += term *= x * x / n;
  return 0.5 + normal_density(x) * sum;
}

}  // namespace eyebridge
