#include "eyebridge/base/math.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "eyebridge/base/hash.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge {
namespace {

double ulp(double x) { return std::nextafter(std::abs(x), 1e300) - std::abs(x); }

TEST(SinCos, AgreesWithLibmToTwoUlpOverManyTurns) {
  std::mt19937_64 gen(1);
  std::uniform_real_distribution<double> angle(-1000.0, 1000.0);
  for (int i = 0; i < 200'000; ++i) {
    const double a = angle(gen);
    const SinCos sc = sin_cos(a);
    // Near a zero of the function the argument reduction, not the series, sets the error.
    ASSERT_NEAR(sc.sin, std::sin(a), 2 * ulp(std::sin(a)) + 2e-16) << a;
    ASSERT_NEAR(sc.cos, std::cos(a), 2 * ulp(std::cos(a)) + 2e-16) << a;
  }
}

TEST(SinCos, IsExactAtZero) {
  EXPECT_EQ(sin_cos(0.0).sin, 0.0);
  EXPECT_EQ(sin_cos(0.0).cos, 1.0);
}

TEST(SinCos, GivesAUnitVector) {
  for (double a = -10; a < 10; a += 0.001) {
    const SinCos sc = sin_cos(a);
    ASSERT_NEAR(sc.sin * sc.sin + sc.cos * sc.cos, 1.0, 5e-16) << a;
  }
}

TEST(SinCos, OfAnyFiniteAngleIsAUnitVector) {
  for (const double angle : {1e6, 1.1e6, 1e9, 1e15, 9.3e18, 1e19, 1e40, 1e300, 1.7e308}) {
    for (const double a : {angle, -angle}) {
      const SinCos sc = sin_cos(a);
      EXPECT_NEAR(sc.sin * sc.sin + sc.cos * sc.cos, 1.0, 5e-16) << a;
    }
  }
  EXPECT_NEAR(sin_cos(1e9).sin, std::sin(1e9), 1e-7);
  EXPECT_NEAR(sin_cos(-1e9).cos, std::cos(1e9), 1e-7);
}

TEST(SinCos, OfWhatIsNoAngleIsNaN) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double a : {kInfinity, -kInfinity, std::nan("")}) {
    EXPECT_TRUE(std::isnan(sin_cos(a).sin)) << a;
    EXPECT_TRUE(std::isnan(sin_cos(a).cos)) << a;
    EXPECT_TRUE(std::isnan(wrap_angle(a))) << a;
  }
}

TEST(ArcTan2, AgreesWithLibmInAllQuadrants) {
  std::mt19937_64 gen(2);
  std::uniform_real_distribution<double> part(-3.0, 3.0);
  for (int i = 0; i < 200'000; ++i) {
    const double y = part(gen);
    const double x = part(gen);
    ASSERT_NEAR(arc_tan2(y, x), std::atan2(y, x), 4 * ulp(std::atan2(y, x)) + 1e-16)
        << y << ' ' << x;
  }
}

TEST(ArcTan2, KnowsTheAxesAndTheNullVector) {
  EXPECT_EQ(arc_tan2(0, 0), 0.0);
  EXPECT_EQ(arc_tan2(0, 1), 0.0);
  EXPECT_DOUBLE_EQ(arc_tan2(1, 0), kPi / 2);
  EXPECT_DOUBLE_EQ(arc_tan2(-1, 0), -kPi / 2);
  EXPECT_DOUBLE_EQ(arc_tan2(0, -1), kPi);
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  constexpr double kMost = std::numeric_limits<double>::max();
  EXPECT_DOUBLE_EQ(arc_tan2(kLeast, kLeast), kPi / 4);
  EXPECT_DOUBLE_EQ(arc_tan2(kMost, -kMost), 3 * kPi / 4);
  EXPECT_DOUBLE_EQ(arc_tan2(kMost / 2, kMost), std::atan2(1.0, 2.0));
}

TEST(LogOf, AgreesWithLibmOverTheWholeRange) {
  std::mt19937_64 gen(3);
  std::uniform_real_distribution<double> exponent(-300.0, 300.0);
  for (int i = 0; i < 200'000; ++i) {
    const double x = std::pow(10.0, exponent(gen));
    ASSERT_NEAR(log_of(x), std::log(x), 4 * ulp(std::log(x))) << x;
  }
  EXPECT_EQ(log_of(1.0), 0.0);
}

TEST(ExpOf, AgreesWithLibmWithinFourUlp) {
  std::mt19937_64 gen(4);
  std::uniform_real_distribution<double> exponent(-680.0, 680.0);
  for (int i = 0; i < 200'000; ++i) {
    const double x = exponent(gen) / (i % 2 == 0 ? 1.0 : 1e3);
    ASSERT_NEAR(exp_of(x), std::exp(x), 4 * ulp(std::exp(x))) << x;
  }
  EXPECT_EQ(exp_of(0.0), 1.0);
}

TEST(ExpOf, EndsInNothingAndInfinity) {
  EXPECT_EQ(exp_of(-800.0), 0.0);
  EXPECT_EQ(exp_of(-std::numeric_limits<double>::infinity()), 0.0);
  EXPECT_NEAR(exp_of(-740.0), std::exp(-740.0), 1e-322);
  EXPECT_EQ(exp_of(800.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(exp_of(std::numeric_limits<double>::infinity()),
            std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(exp_of(std::numeric_limits<double>::quiet_NaN())));
}

TEST(WrapAngle, BringsEveryAngleIntoTheHalfOpenTurn) {
  EXPECT_DOUBLE_EQ(wrap_angle(kPi), kPi);
  EXPECT_DOUBLE_EQ(wrap_angle(-kPi), kPi);
  EXPECT_NEAR(wrap_angle(3 * kPi), kPi, 1e-15);
  EXPECT_NEAR(wrap_angle(kPi + 0.1), -kPi + 0.1, 1e-15);
  for (double a = -100; a < 100; a += 0.01) {
    const double w = wrap_angle(a);
    ASSERT_GT(w, -kPi);
    ASSERT_LE(w, kPi);
    ASSERT_NEAR(std::sin(w), std::sin(a), 1e-13);
  }
  for (const double a : {1e6, 1e9, 1e18, 1e300}) {
    EXPECT_GT(wrap_angle(a), -kPi) << a;
    EXPECT_LE(wrap_angle(a), kPi) << a;
    EXPECT_EQ(wrap_angle(-a), -wrap_angle(a)) << a;
  }
}

TEST(Math, GivesTheSameBitsInEveryBuild) {
  StateHash hash;
  for (double a = -50.0; a < 50.0; a += 0.037) {
    const SinCos sc = sin_cos(a);
    hash.add(sc.sin);
    hash.add(sc.cos);
    hash.add(arc_tan2(sc.sin + 0.1, sc.cos));
    hash.add(log_of(a * a + 0.001));
  }
  EXPECT_EQ(hash.value(), 0x4159aca4ee67cbe2U) << std::hex << hash.value();
}

}  // namespace
}  // namespace eyebridge
