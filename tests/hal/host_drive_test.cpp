#include "board/host_drive.hpp"

#include <algorithm>
#include <map>

#include <gmock/gmock.h>

#include "host_drive_plant.hpp"

namespace eyebridge::hal {
namespace {

using testing::HasSubstr;

TEST(HostDrive, SpeedsBetweenTwoTicksAreReachedOnAverage) {
  Plant plant;
  const double tick_speed = 100.0 / plant_settings(plant_model()).left_ticks_per_metre;
  plant.drive.set_speed({3.3 * tick_speed, 0.0});
  plant.steps(100);
  const auto before = plant.sim.encoder_ticks(plant.robot, 0);
  plant.steps(1000);
  EXPECT_NEAR(static_cast<double>(plant.sim.encoder_ticks(plant.robot, 0) - before), 3300, 1.5);
}

TEST(HostDrive, SpeedIsRampedHeldAndMeasured) {
  Plant plant;
  plant.drive.set_speed({0.3, 0.0});
  plant.steps(16);
  EXPECT_NEAR(plant.sim.twist(plant.robot).linear, 0.16, 0.02) << "1 m/s^2";
  plant.steps(200);
  EXPECT_NEAR(plant.drive.measured_twist().linear, 0.3, 0.0032) << "a tick in 50 ms";
  EXPECT_EQ(plant.drive.status().progress, DriveProgress::Done) << "nothing that could end";
  plant.drive.set_speed({});
  plant.steps(40);
  EXPECT_EQ(plant.drive.measured_twist(), Twist{});
  EXPECT_EQ(*plant.drive.step(plant.counts(), plant.now), (WheelSpeeds{0, 0}));
}

TEST(HostDrive, TooFastIsClampedAndTheCurvatureStays) {
  HostDriveSettings settings = plant_settings(plant_model());
  settings.left_ticks_per_metre = settings.right_ticks_per_metre = 50000;  // 127 are 0.254 m/s
  settings.linear_acceleration = settings.angular_acceleration = 0.0;      // at once
  HostDrive drive(settings);
  drive.set_speed({0.5, 4.0});  // rims at 0.32 and 0.68 m/s
  const auto speeds = drive.step({0, 0}, Time(0));
  ASSERT_TRUE(speeds);
  EXPECT_EQ(speeds->right, 127);
  EXPECT_NEAR(speeds->left, 127 * 0.32 / 0.68, 1.0);
}

TEST(HostDrive, RemainingFallsToZero) {
  Plant plant;
  plant.drive.start({0.5, 0.0, 0.25});
  double last = plant.drive.status().remaining;
  EXPECT_DOUBLE_EQ(last, 0.5);
  while (plant.drive.status().progress == DriveProgress::Driving) {
    plant.step();
    ASSERT_LE(plant.drive.status().remaining, last);
    last = plant.drive.status().remaining;
  }
  EXPECT_EQ(last, 0.0);
  plant.drive.start({0.0, 1.0, 1.0});
  EXPECT_EQ(plant.drive.status().remaining, 0.0) << "turns have no way to go";
}

TEST(HostDrive, GoalsWithoutLengthOrSpeedAreDoneAtOnce) {
  Plant plant;
  for (const DriveGoal& goal : {DriveGoal{0.0, 0.0, 1.0}, DriveGoal{1.0, 0.0, 0.0}}) {
    plant.drive.start(goal);
    EXPECT_EQ(plant.drive.status().progress, DriveProgress::Done);
    EXPECT_EQ(*plant.drive.step(plant.counts(), plant.now), (WheelSpeeds{0, 0}));
  }
}

TEST(HostDrive, MirroredMotorsDriveTheSameWay) {
  HostDriveSettings settings = plant_settings(plant_model());
  settings.right_reversed = true;
  Plant plant(plant_model(), settings);
  plant.drive.start({0.5, 0.7, 0.3});
  plant.step();
  plant.steps(20);
  const auto speeds = plant.drive.step(plant.counts(), plant.now);
  EXPECT_GT(speeds->left, 0);
  EXPECT_LT(speeds->right, 0);
  plant.finish();
  EXPECT_NEAR(plant.sim.pose(plant.robot).theta, 0.7, deg_to_rad(0.5));
  EXPECT_NEAR(plant.drive.odometry().theta, 0.7, deg_to_rad(0.5));
}

TEST(HostDrive, LateCallsLoseNoWay) {
  Plant plant;
  plant.drive.start({1.0, 0.0, 0.3});
  for (int i = 0; plant.drive.status().progress == DriveProgress::Driving && i < 1000; ++i) {
    plant.step(i % 7 == 3 ? 3 : 1);
  }
  plant.steps(20);
  EXPECT_EQ(plant.drive.status().progress, DriveProgress::Done);
  EXPECT_NEAR(plant.sim.pose(plant.robot).x, kPlantRoom / 2 + 1.0, 0.02);
}

// Counts that are old when the speeds that follow from them are sent, and speeds that hold for
// long: both for `periods`. Returns how far the robot went at most.
double drive_on_a_slow_line(Plant& plant, int periods, double seconds) {
  double furthest = 0.0;
  for (int i = 0; i < seconds * 100 / periods; ++i) {
    const WheelCounts counts = plant.counts();
    const Time counted = plant.now;
    for (int period = 0; period < periods; ++period) plant.sim.step();
    plant.now += periods * HostDrive::kPeriod;
    const WheelSpeeds told = plant.drive.step(counts, counted, plant.now - counted).value();
    plant.sim.set_motor_speed(plant.robot, 0, 100.0 * told.left);
    plant.sim.set_motor_speed(plant.robot, 1, 100.0 * told.right);
    furthest = std::max(furthest, plant.sim.pose(plant.robot).x - kPlantRoom / 2);
  }
  return furthest;
}

TEST(HostDrive, ASlowLineNeitherOvershootsNorSwings) {
  for (const int periods : {2, 3, 6, 12}) {
    Plant plant;
    plant.drive.start({0.5, 0.0, 0.2});
    EXPECT_LT(drive_on_a_slow_line(plant, periods, 6.0), 0.505) << periods;
    EXPECT_EQ(plant.drive.status().progress, DriveProgress::Done) << periods;
    EXPECT_NEAR(plant.sim.pose(plant.robot).x - kPlantRoom / 2, 0.5, 5e-3) << periods;
  }
}

// Where the slowest speed passes the goal from one count to the next, the goal must not be passed
// for ever: that looked like a wheel that is held.
TEST(HostDrive, EachTurnOverASlowLineEnds) {
  const std::map<int, double> lines = {{2, 0.8}, {3, 1.0}, {6, 1.5}, {12, 3.2}};
  for (const auto& [periods, off] : lines) {
    for (int degrees = 20; degrees <= 120; ++degrees) {
      Plant plant;
      plant.drive.start({0.0, deg_to_rad(degrees), 1.5});
      drive_on_a_slow_line(plant, periods, 5.0);
      EXPECT_EQ(plant.drive.status().progress, DriveProgress::Done) << periods << " " << degrees;
      EXPECT_NEAR(plant.sim.pose(plant.robot).theta, deg_to_rad(degrees), deg_to_rad(off))
          << periods << " " << degrees;
    }
  }
}

// Every ninth speed holds for ten times as long: wherever that meets the goal, it is not passed
// far.
TEST(HostDrive, AnswersThatAreLateAtTimesDoNotLeadBeyondTheGoal) {
  for (int phase = 0; phase < 9; ++phase) {
    Plant plant;
    plant.drive.start({0.5, 0.0, 0.2});
    double furthest = 0.0;
    int calls = 0;
    for (; plant.drive.status().progress == DriveProgress::Driving && calls < 2000; ++calls) {
      plant.step(calls % 9 == phase ? 10 : 1);
      furthest = std::max(furthest, plant.sim.pose(plant.robot).x - kPlantRoom / 2);
    }
    EXPECT_EQ(plant.drive.status().progress, DriveProgress::Done) << phase;
    EXPECT_LT(furthest, 0.503) << phase;
    EXPECT_NEAR(plant.sim.pose(plant.robot).x - kPlantRoom / 2, 0.5, 2e-3) << phase;
    EXPECT_LT(plant.now, std::chrono::seconds(5)) << phase;
  }
}

TEST(HostDrive, EarlyCallsChangeNothing) {
  Plant plant;
  plant.drive.start({1.0, 0.0, 0.3});
  plant.steps(30);
  const auto speeds = plant.drive.step(plant.counts(), plant.now);
  ASSERT_TRUE(speeds);
  const Pose pose = plant.drive.odometry();
  for (int i = 1; i <= 4; ++i) {
    EXPECT_EQ(*plant.drive.step({1, 2}, plant.now + std::chrono::milliseconds(i)), *speeds);
    EXPECT_EQ(plant.drive.odometry(), pose);
  }
}

TEST(HostDrive, AGapInWhichNothingWasKnownIsAnErrorAndStops) {
  Plant plant;
  plant.drive.start({3.0, 0.0, 0.3});
  plant.steps(100);
  plant.now += std::chrono::milliseconds(2500);
  const auto lost = plant.drive.step(plant.counts(), plant.now);
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().code, Errc::Timeout);
  EXPECT_THAT(lost.error().what, HasSubstr("not read for 2510 ms"));
  EXPECT_EQ(plant.drive.status().progress, DriveProgress::Failed);
  const auto next = plant.drive.step({7, 7}, plant.now + HostDrive::kPeriod);
  ASSERT_TRUE(next);
  EXPECT_EQ(*next, (WheelSpeeds{0, 0}));
  EXPECT_EQ(plant.drive.measured_twist(), Twist{}) << "the jump of the counts is no travel";
}

TEST(HostDrive, TheOdometryKnowsWhatWasDrivenInAGapThatTheCountersSpan) {
  Plant plant;
  plant.drive.set_speed({0.2, 0.5});
  plant.steps(50);
  const Pose before = plant.drive.odometry();
  plant.now += std::chrono::milliseconds(1500);
  for (int i = 0; i < 150; ++i) plant.sim.step();
  const auto late = plant.drive.step(plant.counts(), plant.now);
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().code, Errc::Timeout);
  const Pose after = plant.drive.odometry();
  EXPECT_NEAR(after.theta - before.theta, 0.75, 0.05);
  EXPECT_NEAR(after.theta, plant.sim.pose(plant.robot).theta, 0.02);
  plant.now += HostDrive::kPeriod;
  EXPECT_EQ(*plant.drive.step(plant.counts(), plant.now), (WheelSpeeds{0, 0}));
}

TEST(HostDrive, AWallStallsBothWheelsAndFailsTheGoal) {
  Plant plant;
  plant.sim.set_pose(plant.robot, {kPlantRoom - 0.3, 4.0, 0.0});
  plant.drive.start({1.0, 0.0, 0.3});
  bool stalled_while_driving = false;
  int periods = 0;
  for (; plant.drive.status().progress == DriveProgress::Driving && periods < 1000; ++periods) {
    plant.step();
    const DriveStatus status = plant.drive.status();
    stalled_while_driving |=
        status.progress == DriveProgress::Driving && status.stalled_left && status.stalled_right;
  }
  EXPECT_TRUE(stalled_while_driving);
  const DriveStatus status = plant.drive.status();
  EXPECT_EQ(status.progress, DriveProgress::Failed);
  EXPECT_TRUE(status.stalled_left && status.stalled_right) << "until the next command";
  EXPECT_EQ(*plant.drive.step(plant.counts(), plant.now), (WheelSpeeds{0, 0}));
  plant.drive.start({-0.2, 0.0, 0.3});
  EXPECT_FALSE(plant.drive.status().stalled_left);
  plant.finish();
  EXPECT_EQ(plant.drive.status().progress, DriveProgress::Done);
}

TEST(HostDrive, OneHeldWheelIsToldFromTheOther) {
  HostDrive drive(plant_settings(plant_model()));
  drive.set_speed({0.2, 0.0});
  std::int32_t left = 0;
  Time now{0};
  for (int i = 0; i < 60; ++i, now += HostDrive::kPeriod) {
    const auto speeds = drive.step({left, 500}, now);
    left += speeds->left;
  }
  EXPECT_FALSE(drive.status().stalled_left);
  EXPECT_TRUE(drive.status().stalled_right);
}

TEST(HostDrive, SlowDrivingIsNoStall) {
  Plant plant;
  plant.drive.set_speed({0.002, 0.0});  // a tick in 80 ms
  for (int i = 0; i < 500; ++i) {
    plant.step();
    ASSERT_FALSE(plant.drive.status().stalled_left);
  }
  EXPECT_NEAR(plant.drive.odometry().x, 0.01, 0.0005);
}

TEST(HostDrive, ReleasedMotorsAreTheProgramsAndOdometryGoesOn) {
  Plant plant;
  plant.drive.set_speed({0.2, 0.0});
  plant.steps(50);
  plant.drive.release();
  EXPECT_FALSE(plant.drive.engaged());
  plant.sim.set_motor_speed(plant.robot, 0, 1000);
  plant.sim.set_motor_speed(plant.robot, 1, 1000);
  const double before = plant.drive.odometry().x;
  plant.steps(100);
  EXPECT_NEAR(plant.drive.odometry().x - before, 0.155, 0.005);
  plant.drive.set_speed({0.2, 0.0});
  plant.step();
  EXPECT_NEAR(plant.sim.twist(plant.robot).linear, 0.16, 0.02) << "the ramp starts from its speed";
}

TEST(HostDrive, RestartForgetsTheCountsButNotThePose) {
  Plant plant;
  plant.drive.start({0.5, 0.0, 0.3});
  plant.steps(100);
  const Pose pose = plant.drive.odometry();
  plant.drive.restart();
  EXPECT_EQ(*plant.drive.step({0, 0}, plant.now), (WheelSpeeds{0, 0}));
  EXPECT_EQ(plant.drive.odometry(), pose);
  plant.drive.set_odometry({1.0, 2.0, 0.5});
  EXPECT_NEAR(plant.drive.odometry().theta, 0.5, 1e-12);
}

TEST(HostDrive, WhatTurnsLackDoesNotAddUp) {
  Plant plant;
  for (int i = 0; i < 40; ++i) {
    plant.drive.start({0.0, kPi / 2, 4.0});
    plant.finish();
    plant.drive.start({0.05, 0.0, 0.4});
    plant.finish();
  }
  EXPECT_NEAR(wrap_angle(plant.sim.pose(plant.robot).theta), 0.0, deg_to_rad(0.5));
}

TEST(HostDrive, ARobotTurnedByHandIsNotTurnedBack) {
  Plant plant;
  plant.drive.start({0.0, kPi / 2, 4.0});
  plant.finish();
  plant.drive.release();
  plant.sim.set_motor_speed(plant.robot, 0, -500.0);  // the wheels follow the hand
  plant.sim.set_motor_speed(plant.robot, 1, 500.0);
  plant.steps(100);
  plant.sim.set_motor_speed(plant.robot, 0, 0.0);
  plant.sim.set_motor_speed(plant.robot, 1, 0.0);
  plant.steps(10);
  const double before = plant.sim.pose(plant.robot).theta;
  plant.drive.start({0.0, kPi / 2, 4.0});
  plant.finish();
  EXPECT_NEAR(wrap_angle(plant.sim.pose(plant.robot).theta - before), kPi / 2, deg_to_rad(0.5));
}

}  // namespace
}  // namespace eyebridge::hal
