#include "eyebridge/base/normal.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"

namespace eyebridge {
namespace {

TEST(NormalDistribution, DensityAgreesWithLibm) {
  for (double x = -38.0; x <= 38.0; x += 0.0137) {
    const double expected = std::exp(-x * x / 2) / std::sqrt(2 * kPi);
    // The square alone is off by half a unit in its last place, and the power by as much of it.
    ASSERT_NEAR(normal_density(x) / expected, 1.0, 1e-15 + 3e-16 * x * x) << x;
  }
}

TEST(NormalDistribution, DistributionAgreesWithLibmAlsoFarOutInTheTail) {
  for (double x = -37.0; x <= 10.0; x += 0.0091) {
    const double expected = 0.5 * std::erfc(-x / std::numbers::sqrt2);
    ASSERT_NEAR(normal_below(x) / expected, 1.0, 1e-12) << x;
  }
}

TEST(NormalDistribution, IsSymmetricAndGrows) {
  EXPECT_EQ(normal_below(0.0), 0.5);
  double before = 0.0;
  for (double x = -9.0; x <= 9.0; x += 0.01) {
    ASSERT_NEAR(normal_below(x) + normal_below(-x), 1.0, 4e-16) << x;
    ASSERT_EQ(normal_density(x), normal_density(-x)) << x;
    ASSERT_GE(normal_below(x), before) << x;
    before = normal_below(x);
  }
}

TEST(NormalDistribution, HasItsLimits) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(normal_below(-kInfinity), 0.0);
  EXPECT_EQ(normal_below(kInfinity), 1.0);
  EXPECT_EQ(normal_density(kInfinity), 0.0);
  EXPECT_TRUE(std::isnan(normal_below(std::nan(""))));
  EXPECT_TRUE(std::isnan(normal_density(std::nan(""))));
}

}  // namespace
}  // namespace eyebridge
