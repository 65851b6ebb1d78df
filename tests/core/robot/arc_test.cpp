#include "eyebridge/robot/arc.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/robot/odometry.hpp"

namespace eyebridge::robot {
namespace {

TEST(Arc, QuarterCircleEndsOneRadiusAheadAndOneToTheLeft) {
  const double radius = 0.4;
  const world::Arc arc = arc_of({radius * kPi / 2, kPi / 2});
  EXPECT_NEAR(arc.displacement.x, radius, 1e-15);
  EXPECT_NEAR(arc.displacement.y, radius, 1e-15);
  EXPECT_NEAR(arc.turn.cos, 0.0, 1e-15);
  EXPECT_NEAR(arc.turn.sin, 1.0, 1e-15);
}

TEST(Arc, SeriesAndClosedFormAgreeOnBothSidesOfTheLimit) {
  for (const double angle : {-0.2499, -0.03, -1e-6, 1e-9, 0.01, 0.1, 0.2, 0.2499, 0.2501, 0.3}) {
    const double d = 0.7;
    const world::Arc arc = arc_of({d, angle});
    const double half = angle / 2;
    const double chord = d * std::sin(half) / half;
    EXPECT_NEAR(arc.displacement.x, chord * std::cos(half), 1e-15) << angle;
    EXPECT_NEAR(arc.displacement.y, chord * std::sin(half), 1e-15) << angle;
    EXPECT_NEAR(arc.turn.cos, std::cos(angle), 2e-16) << angle;
    EXPECT_NEAR(arc.turn.sin, std::sin(angle), 2e-16) << angle;
  }
}

TEST(Arc, StraightIsExact) {
  const world::Arc arc = arc_of({0.123, 0.0});
  EXPECT_EQ(arc.displacement, (Vec2{0.123, 0.0}));
  EXPECT_EQ(arc.turn, Heading{});
}

TEST(Arc, WheelsGiveMeanWayAndDifferenceByBase) {
  const PathStep path = path_of({0.10, 0.13}, 0.09);
  EXPECT_DOUBLE_EQ(path.distance, 0.115);
  EXPECT_DOUBLE_EQ(path.angle, 0.03 / 0.09);
}

TEST(Odometry, ManySmallArcsCloseTheCircle) {
  Odometry odometry;
  odometry.set({1.0, 2.0, 0.5});
  constexpr int kSteps = 100000;
  for (int i = 0; i < kSteps; ++i) odometry.add(arc_of({2 * kPi * 0.3 / kSteps, 2 * kPi / kSteps}));
  EXPECT_NEAR(odometry.pose().x, 1.0, 1e-11);
  EXPECT_NEAR(odometry.pose().y, 2.0, 1e-11);
  EXPECT_NEAR(odometry.pose().theta, 0.5, 1e-11);
}

TEST(Odometry, HeadingStaysAUnitVectorOverMillionsOfSteps) {
  Odometry odometry;
  for (int i = 0; i < 2000000; ++i) odometry.add(arc_of({0.001, 0.037}));
  const Heading h = odometry.heading();
  EXPECT_NEAR(h.cos * h.cos + h.sin * h.sin, 1.0, 1e-15);
}

TEST(Odometry, StartsFromThePoseItIsGiven) {
  Odometry odometry;
  odometry.set({1.0, 1.0, kPi / 2});
  odometry.add(arc_of({0.5, 0.0}));
  EXPECT_NEAR(odometry.pose().x, 1.0, 1e-15);
  EXPECT_NEAR(odometry.pose().y, 1.5, 1e-15);
}

}  // namespace
}  // namespace eyebridge::robot
