// Mecanum wheels and three omnidirectional ones against closed forms.

#include <cmath>

#include <gtest/gtest.h>

#include "eyebridge/robot/arc.hpp"
#include "rig.hpp"

namespace eyebridge::robot {
namespace {

/// Speeds at once, so that closed forms hold from the first step.
RobotModel omni_model(DriveKind kind) {
  RobotModel model;
  model.drive.kind = kind;
  model.drive.wheel_base = 0.2;
  model.drive.axle_distance = 0.16;
  model.drive.linear_acceleration = model.drive.angular_acceleration = 0.0;
  return model;
}

double rim_of(const Rig& rig, unsigned wheel) {
  const DriveModel& drive = rig.sim.model(rig.robot).drive;
  return static_cast<double>(rig.sim.encoder_ticks(rig.robot, wheel)) * kPi * drive.wheel_diameter /
         drive.ticks_per_revolution;
}

/// Where a body at the origin is after `t` seconds of a constant twist in its own frame.
Pose screw(const HolonomicTwist& twist, double t) {
  const double w = twist.angular;
  if (w == 0.0) return {twist.linear * t, twist.lateral * t, 0.0};
  // About the point that stands still.
  const Vec2 centre{-twist.lateral / w, twist.linear / w};
  const SinCos sc = sin_cos(w * t);
  const Vec2 arm = Vec2{} - centre;
  return {centre.x + sc.cos * arm.x - sc.sin * arm.y, centre.y + sc.sin * arm.x + sc.cos * arm.y,
          wrap_angle(w * t)};
}

void expect_near(const Pose& pose, const Pose& wanted, double within = 1e-12) {
  EXPECT_NEAR(pose.x, wanted.x, within);
  EXPECT_NEAR(pose.y, wanted.y, within);
  EXPECT_NEAR(wrap_angle(pose.theta - wanted.theta), 0.0, within);
}

TEST(Screw, IsTheCircleAboutThePointThatStandsStill) {
  for (const HolonomicTwist twist : {HolonomicTwist{0.3, 0.2, 1.1}, HolonomicTwist{-0.1, 0.4, -2.5},
                                     HolonomicTwist{0, 0.3, 0.2}, HolonomicTwist{0.2, -0.1, 0.0}}) {
    const world::Arc arc = screw_of(BodyStep{twist.linear, twist.lateral, twist.angular});
    expect_near({arc.displacement.x, arc.displacement.y, arc.turn.angle()}, screw(twist, 1.0),
                1e-15);
  }
  // With next to no turn that formula loses its digits; the first terms of the series do not.
  const world::Arc arc = screw_of(BodyStep{0.1, 0.2, 1e-9});
  EXPECT_NEAR(arc.displacement.x, 0.1 - 0.2 * 1e-9 / 2, 1e-16);
  EXPECT_NEAR(arc.displacement.y, 0.2 + 0.1 * 1e-9 / 2, 1e-16);
}

TEST(Screw, WithoutASidewaysPartHasTheBitsOfTheArc) {
  for (const double angle : {0.0, 1e-9, 0.2, -1.7}) {
    const world::Arc screw_arc = screw_of(BodyStep{0.3, 0.0, angle});
    const world::Arc arc = arc_of(PathStep{0.3, angle});
    EXPECT_EQ(screw_arc.displacement, arc.displacement);
    EXPECT_EQ(screw_arc.turn, arc.turn);
  }
}

class Omni : public ::testing::TestWithParam<DriveKind> {};

TEST_P(Omni, AConstantTwistIsAScrewMotion) {
  for (const HolonomicTwist twist :
       {HolonomicTwist{0.2, 0.0, 0.0}, HolonomicTwist{0.0, 0.2, 0.0},
        HolonomicTwist{0.1, -0.2, 0.0}, HolonomicTwist{0.15, 0.1, 0.8},
        HolonomicTwist{0.0, 0.0, -1.5}, HolonomicTwist{-0.1, 0.2, -0.4}}) {
    Rig rig(omni_model(GetParam()));
    rig.sim.set_twist(rig.robot, twist);
    rig.steps(300);
    const Pose wanted = screw(twist, 3.0);
    expect_near(relative_to({2.0, 2.0, 0.0}, rig.sim.pose(rig.robot)), wanted);
    expect_near(rig.sim.odometry(rig.robot), wanted);
    const HolonomicTwist driven = rig.sim.body_twist(rig.robot);
    EXPECT_NEAR(driven.linear, twist.linear, 1e-12);
    EXPECT_NEAR(driven.lateral, twist.lateral, 1e-12);
    EXPECT_NEAR(driven.angular, twist.angular, 1e-12);
  }
}

TEST_P(Omni, TooMuchForAWheelKeepsItsDirectionAndCurve) {
  Rig rig(omni_model(GetParam()));
  const double top = rig.sim.model(rig.robot).drive.max_linear;
  rig.sim.set_twist(rig.robot, {top, top, 4.0});
  rig.sim.step();
  const HolonomicTwist driven = rig.sim.body_twist(rig.robot);
  EXPECT_NEAR(driven.lateral, driven.linear, 1e-12);
  EXPECT_NEAR(driven.angular, driven.linear * 4.0 / top, 1e-11);
  EXPECT_GT(driven.linear, 0.3);
}

TEST_P(Omni, GoalsOfVOmegaEndExactlyAndForget) {
  RobotModel model = omni_model(GetParam());
  model.drive.linear_acceleration = 1.0;
  model.drive.angular_acceleration = 10.0;
  Rig rig(model);
  rig.sim.set_twist(rig.robot, {0.0, 0.2, 0.0});
  rig.steps(50);
  rig.sim.set_speed(rig.robot, {});
  rig.steps(100);
  EXPECT_EQ(rig.sim.body_twist(rig.robot), HolonomicTwist{});
  rig.sim.set_odometry(rig.robot, {});
  rig.sim.drive(rig.robot, {kPi / 4, kPi / 2, 0.3});
  rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  expect_near(rig.sim.odometry(rig.robot), {0.5, 0.5, kPi / 2}, 1e-9);
}

TEST_P(Omni, StopsSidewaysAgainstAWallAndOthersGoOn) {
  Rig rig(omni_model(GetParam()), {2.0, 3.7, 0.0});
  rig.sim.set_twist(rig.robot, {0.0, 0.3, 0.0});
  rig.steps(200);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth);
  const double to_wall = 4.0 - rig.sim.model(rig.robot).radius();
  EXPECT_NEAR(rig.sim.pose(rig.robot).y, to_wall, 2e-3);
  EXPECT_NEAR(rig.sim.odometry(rig.robot).y, rig.sim.pose(rig.robot).y - 3.7, 1e-9);
  rig.sim.set_twist(rig.robot, {0.0, -0.3, 0.0});
  rig.steps(10);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallNone);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Omni, ::testing::Values(DriveKind::Omni, DriveKind::Swedish),
                         [](const auto& kind) {
                           return kind.param == DriveKind::Omni ? "Mecanum" : "ThreeWheels";
                         });

TEST(Mecanum, WheelsTurnAsTheMotionWants) {
  // Half of both distances together: what a turn takes of a rim.
  const double arm = (0.2 + 0.16) / 2;
  const HolonomicTwist twist{0.1, 0.05, 0.5};
  Rig rig(omni_model(DriveKind::Omni));
  rig.sim.set_twist(rig.robot, twist);
  rig.steps(200);
  EXPECT_NEAR(rim_of(rig, 0), 2 * (0.1 - 0.05 - arm * 0.5), 1e-4);
  EXPECT_NEAR(rim_of(rig, 1), 2 * (0.1 + 0.05 + arm * 0.5), 1e-4);
  EXPECT_NEAR(rim_of(rig, 2), 2 * (0.1 + 0.05 - arm * 0.5), 1e-4);
  EXPECT_NEAR(rim_of(rig, 3), 2 * (0.1 - 0.05 + arm * 0.5), 1e-4);
}

TEST(Mecanum, MotorsDriveItInEveryDirection) {
  const auto driven = [](double a, double b, double c, double d) {
    Rig rig(omni_model(DriveKind::Omni));
    const double duty[] = {a, b, c, d};
    for (unsigned i = 0; i < 4; ++i) rig.sim.set_motor_duty(rig.robot, i, 0.1 * duty[i]);
    rig.sim.step();
    return rig.sim.body_twist(rig.robot);
  };
  const DriveModel drive;
  const double speed = 0.1 * drive.max_wheel_speed * drive.wheel_diameter / 2;
  const auto expect_twist = [](const HolonomicTwist& twist, const HolonomicTwist& wanted) {
    EXPECT_NEAR(twist.linear, wanted.linear, 1e-12);
    EXPECT_NEAR(twist.lateral, wanted.lateral, 1e-12);
    EXPECT_NEAR(twist.angular, wanted.angular, 1e-12);
  };
  expect_twist(driven(1, 1, 1, 1), {speed, 0, 0});
  expect_twist(driven(-1, 1, 1, -1), {0, speed, 0});
  expect_twist(driven(0, 1, 1, 0), {speed / 2, speed / 2, 0});
  expect_twist(driven(-1, 1, -1, 1), {0, 0, speed / 0.18});
}

TEST(Mecanum, AWheelsSpeedIsInRadiansASecond) {
  Rig rig(omni_model(DriveKind::Omni));
  for (unsigned i = 0; i < 4; ++i) rig.sim.set_wheel(rig.robot, i, 5.0);
  rig.steps(100);
  EXPECT_NEAR(rig.sim.odometry(rig.robot).x, 5.0 * 0.054 / 2, 1e-12);
  EXPECT_THROW(rig.sim.set_wheel(rig.robot, 4, 1.0), std::out_of_range);
}

TEST(ThreeWheels, WheelsTurnAsTheMotionWants) {
  const HolonomicTwist twist{0.1, 0.05, 0.5};
  Rig rig(omni_model(DriveKind::Swedish));
  rig.sim.set_twist(rig.robot, twist);
  rig.steps(200);
  const SinCos at = sin_cos(kPi / 3);
  // Along the rim of a wheel at an angle: -sin x + cos y; the left one counts the other way.
  EXPECT_NEAR(rim_of(rig, 0), 2 * (at.sin * 0.1 - at.cos * 0.05 - 0.1 * 0.5), 1e-4);
  EXPECT_NEAR(rim_of(rig, 1), 2 * (at.sin * 0.1 + at.cos * 0.05 + 0.1 * 0.5), 1e-4);
  EXPECT_NEAR(rim_of(rig, 2), 2 * (-0.05 + 0.1 * 0.5), 1e-4);
  EXPECT_THROW(rig.sim.set_motor_duty(rig.robot, 3, 0.1), std::out_of_range);
}

TEST(Mecanum, ADriveByMotorsLeavesNoSidewaysSpeedBehind) {
  RobotModel model = omni_model(DriveKind::Omni);
  model.drive.linear_acceleration = 1.0;
  Rig rig(model);
  rig.sim.set_twist(rig.robot, {0.0, 0.3, 0.0});
  rig.steps(60);
  for (unsigned i = 0; i < 4; ++i) rig.sim.set_motor_duty(rig.robot, i, 0.0);
  rig.sim.step();
  const Pose before = rig.sim.pose(rig.robot);
  rig.sim.set_speed(rig.robot, {});
  rig.steps(50);
  EXPECT_EQ(rig.sim.pose(rig.robot), before);
}

}  // namespace
}  // namespace eyebridge::robot
