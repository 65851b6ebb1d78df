#include "eyebridge/planning/dynamic_window.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "driving.hpp"
#include "eyebridge/planning/path_progress.hpp"
#include "eyebridge/planning/sight.hpp"
#include "eyebridge/planning/theta_star.hpp"

namespace eyebridge::planning {
namespace {

/// A robot under a dynamic window: one step, with a look at all limits.
class WindowDrive {
 public:
  WindowDrive(const BlockedRaster& room, const Pose& start, const DynamicWindowSettings& settings)
      : settings_(settings),
        clearance_(clearance_of(room)),
        window_(settings),
        robot(room, start) {}

  void step(Vec2 goal) {
    const DynamicChoice choice = window_.choose(clearance_, robot.pose(), now, goal);
    constexpr double kRounding = 1e-9;
    const double more = settings_.linear_acceleration * settings_.period + kRounding;
    const double turn = settings_.angular_acceleration * settings_.period + kRounding;
    EXPECT_GE(choice.twist.linear, 0.0);
    EXPECT_LE(choice.twist.linear, settings_.max_linear + kRounding);
    EXPECT_LE(std::abs(choice.twist.angular), settings_.max_angular + kRounding);
    EXPECT_LE(std::abs(choice.twist.linear - now.linear), more);
    EXPECT_LE(std::abs(choice.twist.angular - now.angular), turn);
    now = choice.twist;
    robot.drive(now, settings_.period);
  }
  [[nodiscard]] bool is_at(Vec2 goal) const {
    return now == Twist{} && norm(robot.pose().position() - goal) <= settings_.tolerance;
  }

 private:
  DynamicWindowSettings settings_;
  ClearanceRaster clearance_;
  DynamicWindow window_;

 public:
  test::Driving robot;
  Twist now;
};

TEST(DynamicWindow, ReachesAGoalInTheOpenAndStops) {
  const BlockedRaster room({{0, 0}, 0.05, 80, 80});
  for (const double theta : {0.0, 1.5, 3.1, -2.0}) {
    for (const Vec2 goal : {Vec2{3.5, 2.0}, Vec2{2.2, 2.1}, Vec2{0.4, 0.5}}) {
      WindowDrive drive(room, {2.0, 2.0, theta}, {});
      while (!drive.is_at(goal) && drive.robot.seconds() < 30.0) drive.step(goal);
      EXPECT_TRUE(drive.is_at(goal)) << theta << " to " << goal.x;
    }
  }
}

TEST(DynamicWindow, StopsBeforeAWallThatTheGoalIsBehind) {
  BlockedRaster room({{0, 0}, 0.05, 80, 80});
  for (int row = 0; row < 80; ++row) room[{40, row}] = 1;
  WindowDrive drive(room, {0.5, 2.0, 0.0}, {});
  double fastest = 0.0;
  while (drive.robot.seconds() < 30.0) {
    drive.step({3.5, 2.0});
    fastest = std::max(fastest, drive.now.linear);
  }
  EXPECT_GT(fastest, 0.45);
  EXPECT_GE(drive.robot.nearest(), 0.1);
}

TEST(DynamicWindow, BrakesAlongItsArcWhereNothingElseIsSafe) {
  BlockedRaster room({{0, 0}, 0.05, 80, 80});
  for (int row = 0; row < 80; ++row) room[{40, row}] = 1;
  const DynamicWindow window{DynamicWindowSettings{}};
  const DynamicChoice choice =
      window.choose(clearance_of(room), {1.85, 2.0, 0.0}, {0.5, 0.4}, {3.5, 2.0});
  EXPECT_TRUE(choice.is_braking);
  EXPECT_DOUBLE_EQ(choice.twist.linear, 0.45);
  EXPECT_DOUBLE_EQ(choice.twist.angular / choice.twist.linear, 0.4 / 0.5);
}

TEST(DynamicWindow, FollowsPlansThroughFurnishedRoomsAndTouchesNothing) {
  Random random(81);
  int driven = 0;
  int arrived = 0;
  for (int trial = 0; trial < 50; ++trial) {
    const BlockedRaster room = test::furnished_room(random, 12);
    const DynamicWindowSettings settings;
    const BlockedRaster planned = widened(clearance_of(room), settings.radius + 0.1);
    const BlockedRaster narrow = widened(clearance_of(room), settings.radius);
    const Vec2 start = test::random_place(planned, random);
    const Vec2 goal = test::random_place(planned, random);
    const Planned path = theta_star(planned, start, goal);
    const double heading = (2 * random.uniform() - 1) * kPi;
    if (!path) continue;
    ++driven;
    WindowDrive drive(room, {start.x, start.y, heading}, settings);
    PathProgress progress(path->points);
    while (!drive.is_at(goal) && drive.robot.seconds() < 60.0) {
      const Vec2 position = drive.robot.pose().position();
      progress.advance(position, 0.6);
      drive.step(farthest_in_sight(narrow, progress, position, 0.4));
    }
    if (drive.is_at(goal)) ++arrived;
    EXPECT_TRUE(drive.is_at(goal)) << trial;
    EXPECT_GE(drive.robot.nearest(), settings.radius) << trial;
  }
  EXPECT_GT(driven, 40);
  EXPECT_EQ(arrived, driven);
}

// No plan, goals anywhere, and any weights: it need not arrive, but must not touch.
TEST(DynamicWindow, NeverTouchesWhateverItsGoalsAndWeights) {
  Random random(82);
  double way = 0.0;
  for (int trial = 0; trial < 16; ++trial) {
    const BlockedRaster room = test::furnished_room(random, 25);
    DynamicWindowSettings settings;
    settings.heading_weight = 2 * random.uniform();
    settings.clearance_weight = random.uniform();
    settings.speed_weight = 3 * random.uniform();
    settings.max_linear = 0.2 + 1.5 * random.uniform();
    settings.linear_acceleration = 0.2 + 2 * random.uniform();
    settings.angular_acceleration = 0.5 + 8 * random.uniform();
    settings.period = 0.02 + 0.2 * random.uniform();
    const ClearanceRaster clearance = clearance_of(room);
    const Vec2 start = test::random_place(widened(clearance, settings.radius), random);
    WindowDrive drive(room, {start.x, start.y, (2 * random.uniform() - 1) * kPi}, settings);
    for (int goal = 0; goal < 5; ++goal) {
      const Vec2 place{4 * random.uniform(), 4 * random.uniform()};
      for (int i = 0; i < 25; ++i) drive.step(place);
    }
    way += drive.robot.way();
    EXPECT_GE(drive.robot.nearest(), settings.radius) << trial;
  }
  EXPECT_GT(way, 12.0);
}

TEST(DynamicWindow, RefusesSettingsOutOfRange) {
  DynamicWindowSettings settings;
  settings.period = 0.0;
  EXPECT_THROW(DynamicWindow{settings}, std::invalid_argument);
  settings = {};
  settings.radius = NAN;
  EXPECT_THROW(DynamicWindow{settings}, std::invalid_argument);
  settings = {};
  settings.speed_weight = -1.0;
  EXPECT_THROW(DynamicWindow{settings}, std::invalid_argument);
  settings = {};
  settings.angular_samples = 1;
  EXPECT_THROW(DynamicWindow{settings}, std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::planning
