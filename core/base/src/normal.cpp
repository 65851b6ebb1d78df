#include "eyebridge/base/normal.hpp"

#include <cmath>

#include "eyebridge/base/math.hpp"

namespace eyebridge {
namespace {

constexpr double kRootOfTwoPi = 2.5066282746310005;
constexpr double kFarOut = 38.5;   // beyond, the density is no normal double any more
constexpr double kTailFrom = 2.5;  // where the series gets long and the fraction short

/// The probability of more than `x` > 0.
double upper_tail(double x) {
  // The farther out, the fewer terms make 1e-14: 64 at kTailFrom.
  const int terms = 8 + static_cast<int>(350.0 / (x * x));
  double fraction = x;
  for (int n = terms; n >= 1; --n) fraction = x + n / fraction;
  return normal_density(x) / fraction;
}

}  // namespace

double normal_density(double x) {
  if (!(std::abs(x) <= kFarOut)) return std::isnan(x) ? x : 0.0;
  return exp_of(-0.5 * x * x) / kRootOfTwoPi;
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
