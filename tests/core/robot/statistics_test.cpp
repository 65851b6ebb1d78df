// The statistical tests that other tests rely on, against what is known of them.
#include "statistics.hpp"

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"

namespace eyebridge::testing {
namespace {

std::vector<double> normal_sample(std::size_t count) {
  Random random(11);
  std::vector<double> sample(count);
  for (double& x : sample) x = 5 + 2 * random.gaussian();
  return sample;
}

TEST(Statistics, KolmogorovAndSmirnovTellDistributionsApart) {
  const auto sample = normal_sample(2000);
  const auto p = [&](double mean, double sigma) {
    return ks_p_value(sample, [&](double x) { return normal_cdf(x, mean, sigma); });
  };
  EXPECT_GT(p(5, 2), 0.05);
  EXPECT_LT(p(5.3, 2), kUnlikely) << "another mean";
  EXPECT_LT(p(5, 2.6), kUnlikely) << "another deviation";
  EXPECT_LT(ks_p_value(sample, [](double x) { return std::clamp((x - 5) / 7 + 0.5, 0.0, 1.0); }),
            kUnlikely)
      << "another shape";
}

TEST(Statistics, KolmogorovAndSmirnovGiveTheTabulatedValue) {
  // Of many values the distance 1.358 / sqrt(n) has 5 %: every value half a step and this beyond
  // where it should be.
  constexpr std::size_t kCount = 100000;
  std::vector<double> sample;
  for (std::size_t i = 0; i < kCount; ++i)
    sample.push_back((static_cast<double>(i) + 0.5) / kCount);
  const double shift = 1.3581 / std::sqrt(static_cast<double>(kCount));
  EXPECT_NEAR(ks_p_value(sample, [&](double x) { return std::min(x + shift, 1.0); }), 0.05, 0.001);
}

TEST(Statistics, ChiSquareGivesTheTabulatedValues) {
  // 95 % quantiles: 3.841 with one degree of freedom, 18.307 with ten.
  EXPECT_NEAR(
      chi_square_p_value({100 + std::sqrt(3.841 * 50), 100 - std::sqrt(3.841 * 50)}, {100, 100}),
      0.05, 1e-4);
  std::vector<double> observed(11, 100);
  observed[3] += std::sqrt(18.307 * 50);
  observed[7] -= std::sqrt(18.307 * 50);
  EXPECT_NEAR(chi_square_p_value(observed, std::vector<double>(11, 100)), 0.05, 1e-4);
}

TEST(Statistics, ChiSquareOfWhatCannotBeIsZero) {
  EXPECT_EQ(chi_square_p_value({20000, 0}, {100, 19900}), 0.0);
  EXPECT_LT(binomial_p_value(600, 1000, 0.5), kUnlikely);
  EXPECT_GT(binomial_p_value(520, 1000, 0.5), 0.05);
}

TEST(Statistics, MomentsAreThoseOfTheSample) {
  const Moments moments = moments_of({1, 2, 3, 4});
  EXPECT_DOUBLE_EQ(moments.mean, 2.5);
  EXPECT_DOUBLE_EQ(moments.deviation, std::sqrt(5.0 / 3));
}

}  // namespace
}  // namespace eyebridge::testing
