#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace eyebridge::testing {

/// Mean and standard deviation of a sample.
struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};

inline Moments moments_of(const std::vector<double>& sample) {
  const auto count = static_cast<double>(sample.size());
  double sum = 0.0;
  for (const double x : sample) sum += x;
  const double mean = sum / count;
  double squares = 0.0;
  for (const double x : sample) squares += (x - mean) * (x - mean);
  return {mean, std::sqrt(squares / (count - 1))};
}

/// The distribution function of the normal distribution.
inline double normal_cdf(double x, double mean, double sigma) {
  return 0.5 * std::erfc((mean - x) / (sigma * std::sqrt(2.0)));
}

/// Kolmogorov and Smirnov's test: how likely a sample of the continuous distribution `cdf` is at
/// least as far from it as `sample`. With the correction for finite samples of M. A. Stephens,
/// J. R. Stat. Soc. B 32 (1970) 115; good from 8 values on.
inline double ks_p_value(std::vector<double> sample, const std::function<double(double)>& cdf) {
  std::sort(sample.begin(), sample.end());
  const auto count = static_cast<double>(sample.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double expected = cdf(sample[i]);
    const auto below = static_cast<double>(i);
    distance = std::max({distance, expected - below / count, (below + 1) / count - expected});
  }
  const double root = std::sqrt(count);
  const double lambda = (root + 0.12 + 0.11 / root) * distance;
  if (lambda < 0.2) return 1.0;  // where the series converges slowly, the sum is 1 to 12 digits
  double p = 0.0;
  for (int k = 1; k <= 100; ++k) {
    p += (k % 2 == 1 ? 2.0 : -2.0) * std::exp(-2.0 * k * k * lambda * lambda);
  }
  return std::clamp(p, 0.0, 1.0);
}

/// Pearson's test: how likely counts of these expectations are at least as far from them as
/// `observed`; the expectations sum up to as many. Good from expectations of 5 on. The upper
/// incomplete gamma function by its series, Abramowitz and Stegun 6.5.29.
inline double chi_square_p_value(const std::vector<double>& observed,
                                 const std::vector<double>& expected) {
  double statistic = 0.0;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    statistic += (observed[i] - expected[i]) * (observed[i] - expected[i]) / expected[i];
  }
  const double a = static_cast<double>(observed.size() - 1) / 2;
  const double x = statistic / 2;
  if (x > 600) return 0.0;  // the series would overflow
  double term = 1.0 / a;
  double sum = term;
  for (double n = a + 1; term > 1e-15 * sum; ++n) sum += term *= x / n;
  return std::clamp(1.0 - sum * std::exp(a * std::log(x) - x - std::lgamma(a)), 0.0, 1.0);
}

/// The same for `hits` of `count` independent events of probability `p`.
inline double binomial_p_value(double hits, double count, double p) {
  return chi_square_p_value({hits, count - hits}, {count * p, count * (1 - p)});
}

/// With a fixed seed a test passes or fails for ever; a good model has this chance to fail when a
/// seed is chosen.
inline constexpr double kUnlikely = 1e-3;

/// Expects mean, deviation and shape of a normal distribution.
inline void expect_normal(const std::vector<double>& sample, double mean, double sigma) {
  const Moments moments = moments_of(sample);
  const double error_of_mean = sigma / std::sqrt(static_cast<double>(sample.size()));
  EXPECT_NEAR(moments.mean, mean, 4 * error_of_mean);
  EXPECT_NEAR(moments.deviation, sigma, 4 * error_of_mean / std::sqrt(2.0));
  EXPECT_GT(ks_p_value(sample, [&](double x) { return normal_cdf(x, mean, sigma); }), kUnlikely);
}

}  // namespace eyebridge::testing
