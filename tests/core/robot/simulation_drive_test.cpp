#include <cmath>

#include <gtest/gtest.h>

#include "rig.hpp"

namespace eyebridge::robot {
namespace {

TEST(PerfectDrive, OneMetreEndsAtOneMetre) {
  Rig rig({}, {1.0, 2.0, 0.0});
  rig.sim.drive(rig.robot, {1.0, 0.0, 0.3});
  rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, 2.0, 1e-9);
  EXPECT_NEAR(rig.sim.pose(rig.robot).y, 2.0, 1e-12);
  EXPECT_NEAR(rig.sim.odometry(rig.robot).x, 1.0, 1e-9);
  rig.steps(100);
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, 2.0, 1e-9) << "and stays there";
}

TEST(PerfectDrive, QuarterTurnEndsAtNinetyDegrees) {
  Rig rig;
  rig.sim.drive(rig.robot, {0.0, kPi / 2, 1.0});
  rig.finish();
  EXPECT_NEAR(rig.sim.pose(rig.robot).theta, kPi / 2, 1e-9);
}

TEST(PerfectDrive, TurnBeyondAFullTurnReallyTurnsThatFar) {
  Rig rig;
  rig.sim.drive(rig.robot, {0.0, -(2 * kPi + kPi / 4), 2.0});
  const int steps = rig.finish();
  EXPECT_NEAR(rig.sim.pose(rig.robot).theta, -kPi / 4, 1e-9);
  EXPECT_GT(steps * 0.01, 2.25 * kPi / 2.0);
}

TEST(PerfectDrive, HalfCircleEndsOppositeToItsStart) {
  Rig rig({}, {2.0, 1.0, 0.0});
  const double radius = 0.5;
  rig.sim.drive(rig.robot, {kPi * radius, kPi, 0.3});
  rig.finish();
  const Pose pose = rig.sim.pose(rig.robot);
  EXPECT_NEAR(pose.x, 2.0, 1e-9);
  EXPECT_NEAR(pose.y, 2.0, 1e-9);
  EXPECT_NEAR(std::abs(pose.theta), kPi, 1e-9);
}

TEST(PerfectDrive, OdometryIsTheTruthSeenFromTheStart) {
  const Pose start{1.0, 1.5, 0.7};
  Rig rig({}, start);
  for (const DriveGoal goal : {DriveGoal{0.6, 1.0, 0.4}, DriveGoal{0.0, -2.0, 3.0},
                               DriveGoal{-0.3, 0.0, 0.2}, DriveGoal{0.4, -0.8, 0.5}}) {
    rig.sim.drive(rig.robot, goal);
    rig.finish();
  }
  const Pose believed = transform(start, rig.sim.odometry(rig.robot));
  const Pose truth = rig.sim.pose(rig.robot);
  EXPECT_NEAR(believed.x, truth.x, 1e-12);
  EXPECT_NEAR(believed.y, truth.y, 1e-12);
  EXPECT_NEAR(believed.theta, truth.theta, 1e-12);
}

TEST(PerfectDrive, TwistIsWhatWasAskedAfterTheRamp) {
  Rig rig;
  rig.sim.set_speed(rig.robot, {0.2, 0.9});
  rig.steps(60);
  EXPECT_NEAR(rig.sim.twist(rig.robot).linear, 0.2, 1e-12);
  EXPECT_NEAR(rig.sim.twist(rig.robot).angular, 0.9, 1e-12);
  EXPECT_NEAR(rig.sim.measured_twist(rig.robot).linear, 0.2, 1e-12);
  EXPECT_NEAR(rig.sim.measured_twist(rig.robot).angular, 0.9, 1e-12);
}

TEST(PerfectDrive, WithoutAccelerationThereIsNoRamp) {
  RobotModel model;
  model.drive.linear_acceleration = 0.0;
  model.drive.angular_acceleration = 0.0;
  Rig rig(model, {1.0, 2.0, 0.0});
  rig.sim.set_speed(rig.robot, {0.3, 1.0});
  rig.steps(1);
  EXPECT_NEAR(rig.sim.twist(rig.robot).linear, 0.3, 1e-12);
  EXPECT_NEAR(rig.sim.twist(rig.robot).angular, 1.0, 1e-12);
  rig.sim.stop(rig.robot);
  rig.sim.set_pose(rig.robot, {1.0, 2.0, 0.0});
  rig.sim.drive(rig.robot, {0.9985, 0.5, 0.4});
  EXPECT_EQ(rig.finish(), 250);
  EXPECT_NEAR(rig.sim.pose(rig.robot).theta, 0.5, 1e-9);
}

TEST(PerfectDrive, ARobotThatCannotDriveStraightCanStillTurn) {
  RobotModel model;
  model.drive.max_linear = 0.0;
  Rig rig(model);
  rig.sim.drive(rig.robot, {0.0, 1.0, 1.0});
  rig.finish();
  EXPECT_NEAR(rig.sim.pose(rig.robot).theta, 1.0, 1e-9);
}

TEST(Drive, StopStandsAtOnce) {
  Rig rig;
  rig.sim.set_speed(rig.robot, {0.3, 0.0});
  rig.steps(60);
  const Pose before = rig.sim.pose(rig.robot);
  rig.sim.stop(rig.robot);
  rig.steps(10);
  EXPECT_EQ(rig.sim.pose(rig.robot), before);
  EXPECT_EQ(rig.sim.twist(rig.robot), Twist{});
}

TEST(Drive, HandMovesTheRobotButNotItsOdometry) {
  Rig rig;
  rig.sim.drive(rig.robot, {0.5, 0.0, 0.3});
  rig.steps(50);
  const Pose believed = rig.sim.odometry(rig.robot);
  rig.sim.set_pose(rig.robot, {1.0, 1.0, kPi / 2});
  EXPECT_EQ(rig.sim.odometry(rig.robot), believed);
  EXPECT_EQ(rig.sim.twist(rig.robot), Twist{});
  rig.finish();
  EXPECT_NEAR(rig.sim.pose(rig.robot).y, 1.0 + 0.5 - believed.x, 1e-9) << "the goal goes on";
}

TEST(Drive, OdometryCanBeSet) {
  Rig rig;
  rig.sim.set_odometry(rig.robot, {5.0, 6.0, kPi / 2});
  rig.sim.drive(rig.robot, {0.25, 0.0, 0.3});
  rig.finish();
  EXPECT_NEAR(rig.sim.odometry(rig.robot).x, 5.0, 1e-9);
  EXPECT_NEAR(rig.sim.odometry(rig.robot).y, 6.25, 1e-9);
  for (const double theta : {-1.0, -1.0, 0.0, 2.5}) {
    rig.sim.set_odometry(rig.robot, {5.0, 6.0, theta});
    EXPECT_NEAR(rig.sim.odometry(rig.robot).theta, theta, 1e-12);
  }
}

TEST(Drive, LaggingMotorsStillEndAtTheGoalByOdometry) {
  for (const double time_constant : {0.01, 0.05, 0.15}) {
    RobotModel model;
    model.drive.motor_time_constant = time_constant;
    Rig rig(model, {1.0, 2.0, 0.0});
    rig.sim.drive(rig.robot, {1.0, 0.0, 0.4});
    rig.finish();
    rig.steps(200);
    EXPECT_NEAR(rig.sim.odometry(rig.robot).x, 1.0, 2e-4) << time_constant;
    rig.sim.drive(rig.robot, {0.0, kPi / 2, 2.0});
    rig.finish();
    rig.steps(200);
    EXPECT_NEAR(rig.sim.odometry(rig.robot).theta, kPi / 2, 3e-3) << time_constant;
    EXPECT_EQ(rig.sim.twist(rig.robot), Twist{});
  }
}

TEST(DriveError, UnequalWheelsDriveTheCircleThatGeometrySays) {
  RobotModel model;
  model.drive_error.left_scale = -0.01;
  model.drive_error.right_scale = 0.01;
  Rig rig(model, {1.0, 2.0, 0.0});
  rig.sim.drive(rig.robot, {1.0, 0.0, 0.5});
  rig.finish();
  // Left 0.99 m, right 1.01 m: an arc of 1 m that turns by 0.02 / wheel base.
  const double turn = 0.02 / model.drive.wheel_base;
  const Pose pose = rig.sim.pose(rig.robot);
  EXPECT_NEAR(pose.theta, turn, 1e-9);
  EXPECT_NEAR(pose.x, 1.0 + std::sin(turn) / turn, 1e-9);
  EXPECT_NEAR(pose.y, 2.0 + (1 - std::cos(turn)) / turn, 1e-9);
  EXPECT_NEAR(rig.sim.odometry(rig.robot).x, 1.0, 1e-9) << "the robot believes to be straight";
  EXPECT_NEAR(rig.sim.odometry(rig.robot).y, 0.0, 1e-12);
}

TEST(DriveError, GaussianSlipHasTheSpreadItWasGiven) {
  // n equal steps of length s with a slip of sigma each: the way spreads by sigma s sqrt(n).
  constexpr int kRuns = 400;
  constexpr int kSteps = 100;
  RobotModel model;
  model.drive_error.linear_sigma = 0.2;
  double sum = 0.0;
  double squares = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    SimulationSettings settings;
    settings.seed = static_cast<std::uint64_t>(run);
    Rig rig(model, {1.0, 2.0, 0.0}, settings);
    rig.sim.set_motor_duty(rig.robot, 0, 0.2);
    rig.sim.set_motor_duty(rig.robot, 1, 0.2);
    rig.steps(kSteps);
    const double off = rig.sim.pose(rig.robot).x - 1.0 - rig.sim.odometry(rig.robot).x;
    sum += off;
    squares += off * off;
  }
  const double step = 0.2 * model.drive.max_wheel_speed * model.drive.wheel_diameter / 2 * 0.01;
  const double expected = 0.2 * step * std::sqrt(kSteps);
  EXPECT_NEAR(sum / kRuns, 0.0, 4 * expected / std::sqrt(kRuns));
  EXPECT_NEAR(std::sqrt(squares / kRuns), expected, 0.15 * expected);
}

TEST(DriveError, QuantisedOdometrySeesWholeTicks) {
  RobotModel model;
  model.drive_error.encoder_quantised = true;
  Rig rig(model, {1.0, 2.0, 0.0});
  const double tick = kPi * model.drive.wheel_diameter / model.drive.ticks_per_revolution;
  rig.sim.drive(rig.robot, {1.0, 0.0, 0.3});
  rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  const double ticks = rig.sim.odometry(rig.robot).x / tick;
  EXPECT_NEAR(ticks, std::nearbyint(ticks), 1e-6);
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, 2.0, 2 * tick);
  EXPECT_NE(rig.sim.pose(rig.robot).x - 1.0, rig.sim.odometry(rig.robot).x);
}

TEST(Motors, DutyIsAShareOfTheTopWheelSpeed) {
  RobotModel model;
  Rig rig(model);
  rig.sim.set_motor_duty(rig.robot, 0, 0.25);
  rig.sim.set_motor_duty(rig.robot, 1, 0.25);
  rig.steps(1);
  const double top = model.drive.max_wheel_speed * model.drive.wheel_diameter / 2;
  EXPECT_NEAR(rig.sim.twist(rig.robot).linear, 0.25 * top, 1e-12);
}

TEST(Motors, OneWheelAloneTurnsAroundTheOther) {
  RobotModel model;
  Rig rig(model);
  rig.sim.set_speed(rig.robot, {0.3, 0.0});
  rig.steps(50);
  rig.sim.set_motor_duty(rig.robot, 1, 0.1);
  rig.steps(1);
  const Twist twist = rig.sim.twist(rig.robot);
  EXPECT_NEAR(twist.linear, twist.angular * model.drive.wheel_base / 2, 1e-12);
  EXPECT_GT(twist.angular, 0.0);
}

TEST(Motors, ControlledSpeedIsInTicksPerSecond) {
  for (const double time_constant : {0.0, 0.1}) {
    RobotModel model;
    model.drive.motor_time_constant = time_constant;
    Rig rig(model);
    rig.sim.set_motor_speed(rig.robot, 0, -500.0);
    rig.sim.set_motor_speed(rig.robot, 1, 500.0);
    rig.steps(1000);
    rig.sim.reset_encoder(rig.robot, 0);
    rig.sim.reset_encoder(rig.robot, 1);
    rig.steps(200);
    EXPECT_NEAR(static_cast<double>(rig.sim.encoder_ticks(rig.robot, 0)), -1000.0, 1.0);
    EXPECT_NEAR(static_cast<double>(rig.sim.encoder_ticks(rig.robot, 1)), 1000.0, 1.0);
  }
}

TEST(Motors, SpeedCommandAfterMotorsStartsFromTheSpeedOfTheWheels) {
  Rig rig;
  rig.sim.set_motor_duty(rig.robot, 0, 0.2);
  rig.sim.set_motor_duty(rig.robot, 1, 0.2);
  rig.steps(10);
  const double before = rig.sim.twist(rig.robot).linear;
  rig.sim.set_speed(rig.robot, {0.0, 0.0});
  rig.steps(1);
  EXPECT_NEAR(rig.sim.twist(rig.robot).linear, before - 0.01, 1e-9);
}

TEST(Motors, AMotorCommandEndsAGoal) {
  Rig rig;
  rig.sim.drive(rig.robot, {1.0, 0.0, 0.3});
  rig.steps(10);
  rig.sim.set_motor_duty(rig.robot, 0, 0.0);
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  rig.steps(10);
  EXPECT_EQ(rig.sim.twist(rig.robot), Twist{});
}

TEST(Encoders, CountTheTicksOfTheDistance) {
  RobotModel model;
  Rig rig(model, {1.0, 2.0, 0.0});
  rig.sim.drive(rig.robot, {1.0, 0.0, 0.4});
  rig.finish();
  const double ticks = 1.0 / (kPi * model.drive.wheel_diameter) * model.drive.ticks_per_revolution;
  EXPECT_NEAR(static_cast<double>(rig.sim.encoder_ticks(rig.robot, 0)), ticks, 0.51);
  EXPECT_NEAR(static_cast<double>(rig.sim.encoder_ticks(rig.robot, 1)), ticks, 0.51);
  rig.sim.reset_encoder(rig.robot, 0);
  EXPECT_EQ(rig.sim.encoder_ticks(rig.robot, 0), 0);
  EXPECT_NE(rig.sim.encoder_ticks(rig.robot, 1), 0);
}

}  // namespace
}  // namespace eyebridge::robot
