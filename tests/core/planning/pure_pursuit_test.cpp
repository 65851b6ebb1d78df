#include "eyebridge/planning/pure_pursuit.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "driving.hpp"
#include "eyebridge/planning/clearance.hpp"
#include "eyebridge/planning/theta_star.hpp"

namespace eyebridge::planning {
namespace {

constexpr double kPursuitPeriod = 0.05;

/// Drives until it has arrived or a minute is over, and looks at the limits.
void pursue(PurePursuit& pursuit, const PurePursuitSettings& settings, test::Driving& robot) {
  while (robot.seconds() < 60.0) {
    const Twist twist = pursuit.follow(robot.pose());
    if (pursuit.has_arrived()) return;
    ASSERT_GE(twist.linear, 0.0);
    ASSERT_LE(twist.linear, settings.speed);
    ASSERT_LE(std::abs(twist.angular), settings.max_angular);
    robot.drive(twist, kPursuitPeriod);
  }
}

TEST(PurePursuit, DrivesTheArcThatMeetsThePathAhead) {
  PurePursuitSettings settings;
  settings.lookahead = 0.5;
  PurePursuit pursuit({{0, 0}, {5, 0}}, settings);
  const Twist twist = pursuit.follow({1.0, 0.3, 0.0});
  // 0.5 m away lies (0.4, -0.3) of it: curvature 2 y / L^2.
  EXPECT_DOUBLE_EQ(twist.linear, settings.speed);
  EXPECT_NEAR(twist.angular / twist.linear, -2 * 0.3 / 0.25, 1e-9);
}

TEST(PurePursuit, ComesBackOnAPathThatNeverLeavesItsCircle) {
  const PurePursuitSettings settings;  // looks 0.25 m ahead
  PurePursuit pursuit({{0, 0}, {0.2, 0}, {0, 0}}, settings);
  const Twist first = pursuit.follow({0, 0, 0});
  EXPECT_GT(first.linear, 0.0);
  EXPECT_TRUE(std::isfinite(first.angular));
  // As it goes there and back: at the far end what is left of the path is short enough.
  EXPECT_FALSE(pursuit.has_arrived());
  pursuit.follow({0.1, 0, 0});
  pursuit.follow({0.2, 0, 0});
  pursuit.follow({0.1, 0, kPi});
  pursuit.follow({0, 0, kPi});
  EXPECT_TRUE(pursuit.has_arrived());
}

TEST(PurePursuit, TurnsOnTheSpotTowardsAPathBehindIt) {
  PurePursuit pursuit({{0, 0}, {5, 0}});
  const Twist left = pursuit.follow({0.2, 0.0, -2.0});
  EXPECT_EQ(left.linear, 0.0);
  EXPECT_EQ(left.angular, PurePursuitSettings{}.max_angular);
}

TEST(PurePursuit, JoinsALineFromBesideIt) {
  const BlockedRaster room({{0, 0}, 1.0, 1, 1});
  test::Driving robot(room, {0.0, 0.5, 0.0});
  const PurePursuitSettings settings;
  PurePursuit pursuit({{0, 0}, {5, 0}}, settings);
  while (robot.pose().x < 3.0) robot.drive(pursuit.follow(robot.pose()), kPursuitPeriod);
  EXPECT_NEAR(robot.pose().y, 0.0, 0.01);
  pursue(pursuit, settings, robot);
  EXPECT_TRUE(pursuit.has_arrived());
  EXPECT_LE(norm(robot.pose().position() - Vec2{5, 0}), settings.tolerance);
}

TEST(PurePursuit, FollowsPlannedPathsThroughFurnishedRoomsAndTouchesNothing) {
  Random random(71);
  constexpr double kRadius = 0.1;
  const PurePursuitSettings settings;
  int driven = 0;
  for (int trial = 0; trial < 80; ++trial) {
    const BlockedRaster room = test::furnished_room(random, 12);
    const BlockedRaster planned =
        widened(clearance_of(room), kRadius + 0.4 * settings.lookahead + 0.71 * 0.05);
    const Vec2 start = test::random_place(planned, random);
    const Vec2 goal = test::random_place(planned, random);
    const Planned path = theta_star(planned, start, goal);
    const double heading = (2 * random.uniform() - 1) * kPi;
    if (!path) continue;
    ++driven;
    test::Driving robot(room, {start.x, start.y, heading});
    PurePursuit pursuit(path->points, settings);
    pursue(pursuit, settings, robot);
    if (HasFatalFailure()) return;
    EXPECT_TRUE(pursuit.has_arrived()) << trial;
    EXPECT_LE(norm(robot.pose().position() - goal), settings.tolerance) << trial;
    EXPECT_GE(robot.nearest(), kRadius) << trial;
    EXPECT_LE(robot.way(), 1.1 * path->length + 0.1) << trial;
  }
  EXPECT_GT(driven, 60);
}

TEST(PurePursuit, RefusesSettingsOutOfRange) {
  PurePursuitSettings settings;
  settings.lookahead = 0.0;
  EXPECT_THROW(PurePursuit({{0, 0}}, settings), std::invalid_argument);
  settings = {};
  settings.speed = NAN;
  EXPECT_THROW(PurePursuit({{0, 0}}, settings), std::invalid_argument);
  EXPECT_THROW(PurePursuit({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::planning
