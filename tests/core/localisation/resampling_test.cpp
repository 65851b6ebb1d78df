#include "eyebridge/localisation/resampling.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"

namespace eyebridge::localisation {
namespace {

TEST(LowVarianceSample, TakesEachAsOftenAsItsWeightSaysRoundedUpOrDown) {
  Random random(3);
  std::vector<std::size_t> chosen;
  for (int round = 0; round < 200; ++round) {
    std::vector<double> weights(1 + random.bits() % 40);
    double total = 0;
    for (double& w : weights) total += w = random.chance(0.3) ? 0.0 : random.uniform();
    if (total == 0) continue;
    const std::size_t count = 1 + random.bits() % 100;
    low_variance_sample(weights, count, random.uniform(), chosen);
    ASSERT_EQ(chosen.size(), count);
    ASSERT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double expected = weights[i] / total * static_cast<double>(count);
      const auto times = static_cast<double>(std::count(chosen.begin(), chosen.end(), i));
      ASSERT_GT(times, expected - 1 - 1e-9);
      ASSERT_LT(times, expected + 1 + 1e-9);
      if (weights[i] == 0) {
        ASSERT_EQ(times, 0);
      }
    }
  }
}

TEST(LowVarianceSample, IsUnbiasedOverItsRandomNumber) {
  const std::vector<double> weights = {0.1, 0.25, 0.65};
  std::vector<double> times(3, 0.0);
  std::vector<std::size_t> chosen;
  constexpr int kRounds = 10000;
  for (int i = 0; i < kRounds; ++i) {
    low_variance_sample(weights, 1, (i + 0.5) / kRounds, chosen);
    ++times[chosen.at(0)];
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(times[i] / kRounds, weights[i], 2e-4);
}

TEST(KldSampleSize, IsTheChiSquareQuantileOverTwiceTheError) {
  // 99 % quantiles of chi-square: 21.666 for 9, 135.807 for 100 degrees of freedom.
  EXPECT_NEAR(kld_sample_size(10, 0.05, 2.326), 21.666 / 0.1, 0.005 * 216.66);
  EXPECT_NEAR(kld_sample_size(101, 0.05, 2.326), 135.807 / 0.1, 0.001 * 1358.07);
  EXPECT_EQ(kld_sample_size(1, 0.05, 2.326), 1.0);
  EXPECT_EQ(kld_sample_size(0, 0.05, 2.326), 1.0);
}

}  // namespace
}  // namespace eyebridge::localisation
