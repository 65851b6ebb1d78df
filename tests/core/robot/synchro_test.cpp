// Wheels that are steered together, and what errors do to drives with a chassis.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/robot/arc.hpp"
#include "rig.hpp"

namespace eyebridge::robot {
namespace {

RobotModel model_with(DriveKind kind) {
  RobotModel model;
  model.drive.kind = kind;
  return model;
}

TEST(Synchro, TurnsItsWheelsAndKeepsItsBody) {
  Rig rig(model_with(DriveKind::Synchro));
  rig.sim.drive(rig.robot, {0.0, kPi / 2, 2.0});
  rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  EXPECT_EQ(rig.sim.pose(rig.robot), (Pose{2.0, 2.0, 0.0}));
  EXPECT_NEAR(rig.sim.steering(rig.robot), kPi / 2, 1e-9);
  EXPECT_NEAR(rig.sim.odometry(rig.robot).theta, kPi / 2, 1e-9);
  rig.sim.drive(rig.robot, {0.5, 0.0, 0.3});
  rig.finish();
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, 2.0, 1e-9);
  EXPECT_NEAR(rig.sim.pose(rig.robot).y, 2.5, 1e-9);
  EXPECT_EQ(rig.sim.pose(rig.robot).theta, 0.0);
  EXPECT_NEAR(rig.sim.odometry(rig.robot).y, 0.5, 1e-9);
}

TEST(Synchro, ACurveIsACircleOfTheBodyThatDoesNotTurn) {
  Rig rig(model_with(DriveKind::Synchro), {2.0, 2.0, 1.0});
  rig.sim.drive(rig.robot, {0.8, 2.5, 0.3});
  rig.finish();
  const world::Arc arc = arc_of(PathStep{0.8, 2.5});
  const Vec2 wanted = Vec2{2.0, 2.0} + Heading::from_angle(1.0).rotate(arc.displacement);
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, wanted.x, 1e-9);
  EXPECT_NEAR(rig.sim.pose(rig.robot).y, wanted.y, 1e-9);
  EXPECT_NEAR(rig.sim.pose(rig.robot).theta, 1.0, 1e-15);
}

TEST(Synchro, MotorsRollAndSteer) {
  Rig rig(model_with(DriveKind::Synchro));
  rig.sim.set_wheel(rig.robot, 1, 1.0);
  rig.steps(150);
  EXPECT_NEAR(rig.sim.steering(rig.robot), 1.5, 1e-9);
  // 1100 ticks a turn of the wheels, either way.
  EXPECT_EQ(rig.sim.encoder_ticks(rig.robot, 1), std::lround(1100 * 1.5 / (2 * kPi)));
  rig.sim.set_wheel(rig.robot, 1, 0.0);
  rig.sim.set_wheel(rig.robot, 0, 4.0);
  rig.steps(100);
  EXPECT_EQ(rig.sim.encoder_ticks(rig.robot, 0), std::lround(1100 * 4.0 / (2 * kPi)));
  const Vec2 way = relative_to({2.0, 2.0, 0.0}, rig.sim.pose(rig.robot)).position();
  EXPECT_NEAR(way.x, 4.0 * 0.027 * sin_cos(1.5).cos, 1e-9);
  EXPECT_NEAR(way.y, 4.0 * 0.027 * sin_cos(1.5).sin, 1e-9);
}

TEST(Synchro, ATwistSteersTheShorterWayAndDrivesThere) {
  for (const HolonomicTwist twist :
       {HolonomicTwist{0.2, 0.0, 0.0}, HolonomicTwist{0.1, 0.2, 0.0},
        HolonomicTwist{-0.2, 0.05, 0.0}, HolonomicTwist{0.0, -0.2, 0.0}}) {
    Rig rig(model_with(DriveKind::Synchro));
    rig.sim.set_twist(rig.robot, twist);
    rig.steps(300);
    EXPECT_LE(std::abs(rig.sim.steering(rig.robot)), kPi / 2 + 1e-9);
    const HolonomicTwist driven = rig.sim.body_twist(rig.robot);
    EXPECT_NEAR(driven.linear, twist.linear, 1e-8);
    EXPECT_NEAR(driven.lateral, twist.lateral, 1e-8);
    EXPECT_EQ(driven.angular, 0.0);
  }
}

TEST(Synchro, SteersAwayFromAWall) {
  Rig rig(model_with(DriveKind::Synchro), {3.7, 2.0, 0.0});
  rig.sim.set_speed(rig.robot, {0.3, 0.0});
  rig.steps(150);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth);
  rig.sim.drive(rig.robot, {0.0, kPi, 3.0});
  rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  rig.sim.drive(rig.robot, {0.5, 0.0, 0.3});
  rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, 4.0 - 0.093 - 0.5, 1e-3);
}

class ChassisErrors : public ::testing::TestWithParam<DriveKind> {};

TEST_P(ChassisErrors, AScaleOfBothSidesIsAFactorOfTheWay) {
  RobotModel model = model_with(GetParam());
  model.drive_error.left_scale = model.drive_error.right_scale = 0.05;
  Rig rig(model);
  rig.sim.drive(rig.robot, {0.8, 0.0, 0.3});
  rig.finish();
  EXPECT_NEAR(rig.sim.odometry(rig.robot).x, 0.8, 1e-9);
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, 2.0 + 0.8 * 1.05, 1e-9);
}

TEST_P(ChassisErrors, SlipCostsItsShareOfTheWay) {
  RobotModel model = model_with(GetParam());
  model.drive_error.slip = 0.2;
  Rig rig(model, {1.0, 2.0, 0.0});
  rig.sim.drive(rig.robot, {1.5, 0.0, 0.3});
  rig.finish();
  EXPECT_NEAR(rig.sim.odometry(rig.robot).x, 1.5, 1e-9);
  // Of some 500 steps each wheel loses a fifth.
  const Vec2 way = rig.sim.pose(rig.robot).position() - Vec2{1.0, 2.0};
  EXPECT_NEAR(norm(way) / 1.5, 0.8, 0.1);
  EXPECT_LT(norm(way) / 1.5, 0.95);
}

TEST_P(ChassisErrors, CountedTicksStillEndGoals) {
  RobotModel model = model_with(GetParam());
  model.drive_error.encoder_quantised = true;
  model.drive_error.encoder_miss = 0.01;
  model.drive.motor_time_constant = 0.03;
  Rig rig(model);
  for (int i = 0; i < 4; ++i) {
    rig.sim.drive(rig.robot, {0.8, 1.0, 0.3});
    rig.finish();
    EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  }
  EXPECT_NEAR(wrap_angle(rig.sim.odometry(rig.robot).theta - 4.0), 0.0, 0.1);
}

TEST_P(ChassisErrors, TheSameRunHasTheSameHashAndAnotherSeedAnother) {
  const auto run = [](std::uint64_t seed) {
    RobotModel model = model_with(GetParam());
    model.drive.motor_time_constant = 0.05;
    model.drive_error = {0.02, 0.03, 0.01, -0.01, true, 0.02, 0.01};
    SimulationSettings settings;
    settings.seed = seed;
    Simulation sim(room(2.0, 2.0), settings);
    for (int i = 0; i < 4; ++i) sim.add_robot(model, {0.4 + 0.3 * i, 0.5 + 0.3 * i, 0.7 * i});
    Random random(7);
    for (int step = 0; step < 2000; ++step) {
      const auto robot = static_cast<RobotIndex>(step % 4);
      const double a = 2 * random.uniform() - 1;
      const double b = 2 * random.uniform() - 1;
      if (step % 50 < 4) sim.drive(robot, {a, 2 * b, 0.4});
      if (step % 90 < 4) sim.set_twist(robot, {0.3 * a, 0.3 * b, a - b});
      if (step % 170 < 4) sim.set_motor_duty(robot, 0, a);
      sim.step();
    }
    EXPECT_GT(sim.collision_count(), 3u);
    return sim.state_hash();
  };
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
}

std::string name_of_kind(const ::testing::TestParamInfo<DriveKind>& kind) {
  switch (kind.param) {
    case DriveKind::Ackermann:
      return "Ackermann";
    case DriveKind::Omni:
      return "Mecanum";
    case DriveKind::Swedish:
      return "ThreeWheels";
    case DriveKind::Synchro:
      return "Synchro";
    case DriveKind::Submarine:
      return "Submarine";
    case DriveKind::Differential:
      break;
  }
  return "Differential";
}

INSTANTIATE_TEST_SUITE_P(Kinds, ChassisErrors,
                         ::testing::Values(DriveKind::Ackermann, DriveKind::Omni,
                                           DriveKind::Swedish, DriveKind::Synchro,
                                           DriveKind::Submarine),
                         name_of_kind);

TEST(Chassis, ADifferentialDriveTakesTheSameTwistsAndWheels) {
  Rig rig;
  rig.sim.set_twist(rig.robot, {0.2, 0.5, 0.0});
  rig.steps(100);
  EXPECT_EQ(rig.sim.body_twist(rig.robot), (HolonomicTwist{0.2, 0.0, 0.0}));
  rig.sim.set_wheel(rig.robot, 0, 3.0);
  rig.sim.set_wheel(rig.robot, 1, 3.0);
  rig.sim.step();
  EXPECT_NEAR(rig.sim.twist(rig.robot).linear, 3.0 * 0.027, 1e-12);
}

}  // namespace
}  // namespace eyebridge::robot
