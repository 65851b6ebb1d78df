#include "eyebridge/base/random.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace eyebridge {
namespace {

TEST(Random, SameSeedAndStreamGiveTheSameNumbers) {
  Random a(7, 3);
  Random b(7, 3);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(a.bits(), b.bits());
}

TEST(Random, StreamsAndSeedsDiffer) {
  Random a(7, 3);
  Random b(7, 4);
  Random c(8, 3);
  const auto first = a.bits();
  EXPECT_NE(first, b.bits());
  EXPECT_NE(first, c.bits());
}

TEST(Random, UniformFillsTheHalfOpenUnitInterval) {
  Random random(1);
  double sum = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
  }
  EXPECT_NEAR(sum / 100'000, 0.5, 0.005);
}

TEST(Random, GaussianHasTheMomentsAndTailsOfTheNormalDistribution) {
  Random random(2);
  constexpr int kCount = 400'000;
  double sum = 0;
  double squares = 0;
  double fourth = 0;
  int beyond_two = 0;
  int beyond_four = 0;
  for (int i = 0; i < kCount; ++i) {
    const double g = random.gaussian();
    sum += g;
    squares += g * g;
    fourth += g * g * g * g;
    beyond_two += std::abs(g) > 2 ? 1 : 0;
    beyond_four += std::abs(g) > 4 ? 1 : 0;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.006);
  EXPECT_NEAR(squares / kCount, 1.0, 0.01);
  EXPECT_NEAR(fourth / kCount, 3.0, 0.08);
  EXPECT_NEAR(static_cast<double>(beyond_two) / kCount, 0.0455, 0.0015);
  EXPECT_GT(beyond_four, 8);  // expected 25
  EXPECT_LT(beyond_four, 50);
}

}  // namespace
}  // namespace eyebridge
