// The central test: how a robot moves by v and omega. Its rows are in backend_contract_test.cpp.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "backend_contract.hpp"
#include "eyebridge/base/math.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

constexpr double kSpeed = 0.3;  // metres per second
// For movements that must still be under way when the test looks, however late it does.
constexpr double kSlowly = 0.05;

TEST_P(BackendContract, StandsStillUntilItIsTold) {
  const Rig rig = make(0.5);
  rig.wait(1.0);
  EXPECT_NEAR(front(rig), 0.5, traits().range);
  expect_truly_at(rig, facing(0.5));
  EXPECT_EQ(must(rig.backend->drive()->status()).progress, DriveProgress::Done);
}

TEST_P(BackendContract, DrivesStraightAsFarAsItIsTold) {
  for (const double distance : {0.4, -0.3}) {
    const Rig rig = make(1.0);
    ASSERT_TRUE(rig.backend->drive()->start({distance, 0.0, kSpeed}));
    const DriveStatus status = rig.wait_for_drive();
    EXPECT_EQ(status.progress, DriveProgress::Done);
    EXPECT_NEAR(status.remaining, 0.0, traits().way);
    rig.wait(traits().age);
    EXPECT_NEAR(front(rig), 1.0 - distance, traits().way + traits().range);
    expect_truly_at(rig, facing(1.0 - distance));
    EXPECT_NEAR(odometry(rig).x, distance, traits().way);
    EXPECT_NEAR(odometry(rig).y, 0.0, traits().way);
  }
}

TEST_P(BackendContract, TurnsOnTheSpotAsFarAsItIsTold) {
  for (const double angle : {kPi / 2, -kPi / 4}) {
    const Rig rig = make(1.0);
    ASSERT_TRUE(rig.backend->drive()->start({0.0, angle, 1.0}));
    EXPECT_EQ(rig.wait_for_drive().progress, DriveProgress::Done);
    rig.wait(traits().age);
    Pose turned = facing(1.0);
    turned.theta = angle;
    expect_truly_at(rig, turned);
    EXPECT_NEAR(odometry(rig).theta, angle, traits().turn);
    EXPECT_NEAR(odometry(rig).x, 0.0, traits().way);
  }
}

TEST_P(BackendContract, DoesNotPassItsGoal) {
  const auto farthest = [](const Rig& rig) {
    Pose most = odometry(rig);
    for (int i = 0; i < 200; ++i) {
      rig.wait(0.01);
      const Pose now = odometry(rig);
      most = {std::max(most.x, now.x), 0.0, std::max(most.theta, now.theta)};
    }
    return most;
  };
  {
    const Rig straight = make(1.5);
    ASSERT_TRUE(straight.backend->drive()->start({0.3, 0.0, kSpeed}));
    EXPECT_NEAR(farthest(straight).x, 0.3, traits().way);
  }
  const Rig turning = make(1.5);
  ASSERT_TRUE(turning.backend->drive()->start({0.0, kPi / 2, 2.0}));
  EXPECT_NEAR(farthest(turning).theta, kPi / 2, traits().turn);
}

TEST_P(BackendContract, DrivesAQuarterCircle) {
  const Rig rig = make(1.5);
  constexpr double kRadius = 0.4;
  ASSERT_TRUE(rig.backend->drive()->start({kRadius * kPi / 2, kPi / 2, kSpeed}));
  EXPECT_EQ(rig.wait_for_drive().progress, DriveProgress::Done);
  rig.wait(traits().age);
  Pose reached = facing(1.5 - kRadius);
  reached.y += kRadius;
  reached.theta = kPi / 2;
  expect_truly_at(rig, reached);
  EXPECT_NEAR(odometry(rig).x, kRadius, traits().way);
  EXPECT_NEAR(odometry(rig).y, kRadius, traits().way);
  EXPECT_NEAR(odometry(rig).theta, kPi / 2, traits().turn);
}

TEST_P(BackendContract, SaysHowFarItHasToGo) {
  const Rig rig = make(1.5);
  ASSERT_TRUE(rig.backend->drive()->start({1.0, 0.0, kSlowly}));
  rig.wait(3.0);
  const double before = odometry(rig).x;
  const DriveStatus status = must(rig.backend->drive()->status());
  rig.wait(traits().age);
  const double after = odometry(rig).x;
  EXPECT_EQ(status.progress, DriveProgress::Driving);
  EXPECT_GT(before, 0.1);
  // What was read first may be old.
  const double slack = traits().way + kSlowly * traits().age;
  EXPECT_LE(status.remaining, 1.0 - before + slack);
  EXPECT_GE(status.remaining, 1.0 - after - slack);
}

TEST_P(BackendContract, AGoalWithoutLengthIsDoneAtOnceAndStopsTheRobot) {
  const Rig rig = make(1.5);
  ASSERT_TRUE(rig.backend->drive()->set_speed({kSpeed, 0.0}));
  rig.wait(0.5);
  ASSERT_TRUE(rig.backend->drive()->start({0.0, 0.0, kSpeed}));
  EXPECT_EQ(must(rig.backend->drive()->status()).progress, DriveProgress::Done);
  rig.wait(1.0);
  const double stopped = front(rig);
  EXPECT_LT(stopped, 1.45);
  rig.wait(0.5);
  EXPECT_NEAR(front(rig), stopped, traits().range);
}

TEST_P(BackendContract, ANewCommandReplacesTheRunningOne) {
  const Rig rig = make(1.5);
  ASSERT_TRUE(rig.backend->drive()->start({1.2, 0.0, kSlowly}));
  rig.wait(0.5);
  ASSERT_TRUE(rig.backend->drive()->start({0.0, kPi / 2, 1.0}));
  EXPECT_EQ(rig.wait_for_drive().progress, DriveProgress::Done);
  rig.wait(traits().age);
  EXPECT_LT(odometry(rig).x, 1.0);
  EXPECT_NEAR(odometry(rig).theta, kPi / 2, 0.05);  // it was not at rest when the turn began
}

TEST_P(BackendContract, StallsAtTheWallAndGivesUp) {
  const Rig rig = make(0.2);
  ASSERT_TRUE(rig.backend->drive()->start({1.0, 0.0, kSpeed}));
  const DriveStatus status = rig.wait_for_drive();
  EXPECT_EQ(status.progress, DriveProgress::Failed);
  EXPECT_EQ(status.stalled_left, traits().stalls);
  EXPECT_EQ(status.stalled_right, traits().stalls);
  const double gap = rig_model().radius() - kFrontOffset;  // the rim touches, not the sensor
  EXPECT_NEAR(front(rig), gap, 2e-3 + traits().range);
  // The next command begins afresh.
  ASSERT_TRUE(rig.backend->drive()->start({-0.1, 0.0, kSpeed}));
  EXPECT_EQ(rig.wait_for_drive().progress, DriveProgress::Done);
}

TEST_P(BackendContract, ShowsTheStallWhileItPushes) {
  const Rig rig = make(0.2);
  ASSERT_TRUE(rig.backend->drive()->set_speed({kSpeed, 0.0}));
  rig.wait(1.5);
  const DriveStatus status = must(rig.backend->drive()->status());
  EXPECT_EQ(status.progress, DriveProgress::Done);  // there is no goal that could fail
  EXPECT_EQ(status.stalled_left, traits().stalls);
  EXPECT_EQ(status.stalled_right, traits().stalls);
  ASSERT_TRUE(rig.backend->drive()->set_speed({-kSlowly, 0.0}));
  rig.wait(0.5);
  EXPECT_FALSE(must(rig.backend->drive()->status()).stalled_left);
}

TEST_P(BackendContract, KeepsASpeedUntilTheNextCommand) {
  const Rig rig = make(1.5);
  ASSERT_TRUE(rig.backend->drive()->set_speed({0.2, 0.5}));
  rig.wait(1.0);
  const Twist twist = must(rig.backend->drive()->measured_twist());
  EXPECT_NEAR(twist.linear, 0.2, traits().linear);
  EXPECT_NEAR(twist.angular, 0.5, traits().angular);
  ASSERT_TRUE(rig.backend->drive()->set_speed({0.0, 0.0}));
  rig.wait(1.0);
  EXPECT_EQ(must(rig.backend->drive()->measured_twist()), Twist{});
  const Pose pose = odometry(rig);
  rig.wait(0.5);
  EXPECT_NEAR(odometry(rig).x, pose.x, 1e-9);
  EXPECT_NEAR(odometry(rig).theta, pose.theta, 1e-9);
}

TEST_P(BackendContract, DrivesNoFasterThanItCan) {
  const Rig rig = make(1.8);
  ASSERT_TRUE(rig.backend->drive()->set_speed({10.0, 0.0}));
  rig.wait(1.2);
  EXPECT_NEAR(must(rig.backend->drive()->measured_twist()).linear, rig_model().drive.max_linear,
              traits().linear);
}

TEST_P(BackendContract, OdometryGoesOnFromWhereItIsSet) {
  const Rig rig = make(1.5);
  ASSERT_TRUE(rig.backend->drive()->set_odometry({1.0, 2.0, kPi / 2}));
  EXPECT_NEAR(odometry(rig).x, 1.0, 1e-9);
  EXPECT_NEAR(odometry(rig).y, 2.0, 1e-9);
  EXPECT_NEAR(odometry(rig).theta, kPi / 2, 1e-9);
  ASSERT_TRUE(rig.backend->drive()->start({0.3, 0.0, kSpeed}));
  rig.wait_for_drive();
  rig.wait(traits().age);
  EXPECT_NEAR(odometry(rig).x, 1.0, traits().way);
  EXPECT_NEAR(odometry(rig).y, 2.3, traits().way);
}

TEST_P(BackendContract, OdometryIsSetUnderWay) {
  const Rig rig = make(1.5);
  ASSERT_TRUE(rig.backend->drive()->start({0.6, 0.0, kSpeed}));
  rig.wait(1.0);
  const double gone = odometry(rig).x;
  ASSERT_TRUE(rig.backend->drive()->set_odometry({}));
  EXPECT_EQ(rig.wait_for_drive().progress, DriveProgress::Done);
  rig.wait(traits().age);
  EXPECT_NEAR(front(rig), 1.5 - 0.6, traits().way + traits().range);
  // Between the two calls the robot drove on.
  EXPECT_LT(odometry(rig).x, 0.6 - gone + traits().way);
  EXPECT_GT(odometry(rig).x, 0.0);
}

}  // namespace
}  // namespace eyebridge::hal
