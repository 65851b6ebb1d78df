// Cars against closed forms, and what they cannot do.

#include <cmath>

#include <gtest/gtest.h>

#include "eyebridge/robot/arc.hpp"
#include "rig.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kAxles = 0.16;
constexpr double kTrack = 0.1;
constexpr double kLock = deg_to_rad(30);

RobotModel car() {
  RobotModel model;
  model.drive.kind = DriveKind::Ackermann;
  model.drive.axle_distance = kAxles;
  model.drive.wheel_base = kTrack;
  model.drive.max_steering = kLock;
  return model;
}

double sharpest() { return sin_cos(kLock).sin / sin_cos(kLock).cos / kAxles; }

double rim_travel(const Rig& rig, unsigned wheel) {
  const DriveModel& drive = rig.sim.model(rig.robot).drive;
  return static_cast<double>(rig.sim.encoder_ticks(rig.robot, wheel)) * kPi * drive.wheel_diameter /
         drive.ticks_per_revolution;
}

TEST(Ackermann, StraightsAndCurvesEndExactly) {
  for (const DriveGoal goal :
       {DriveGoal{0.7, 0.0, 0.3}, DriveGoal{-0.5, 0.0, 0.3}, DriveGoal{0.8, 1.2, 0.4},
        DriveGoal{0.8, -2.0, 0.4}, DriveGoal{-0.8, 2.0, 0.4}}) {
    Rig rig(car());
    rig.sim.drive(rig.robot, goal);
    rig.finish();
    EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
    const world::Arc arc = arc_of(PathStep{goal.distance, goal.angle});
    const Pose pose = relative_to({2.0, 2.0, 0.0}, rig.sim.pose(rig.robot));
    EXPECT_NEAR(pose.x, arc.displacement.x, 1e-9);
    EXPECT_NEAR(pose.y, arc.displacement.y, 1e-9);
    EXPECT_NEAR(wrap_angle(pose.theta - goal.angle), 0.0, 1e-9);
    const Pose odometry = rig.sim.odometry(rig.robot);
    EXPECT_NEAR(odometry.x, pose.x, 1e-9);
    EXPECT_NEAR(odometry.y, pose.y, 1e-9);
  }
}

TEST(Ackermann, ASteeringAngleIsACircleOfTheBicyclesRadius) {
  const double steering = 0.4;
  Rig rig(car());
  rig.sim.set_steering(rig.robot, steering);
  rig.sim.set_motor_duty(rig.robot, 0, 0.2);
  const double speed = 0.2 * 62.83 * 0.027;
  const double radius = kAxles * sin_cos(steering).cos / sin_cos(steering).sin;
  rig.steps(250);
  const double turned = 2.5 * speed / radius;
  const Pose pose = relative_to({2.0, 2.0, 0.0}, rig.sim.pose(rig.robot));
  EXPECT_NEAR(pose.x, radius * sin_cos(turned).sin, 1e-9);
  EXPECT_NEAR(pose.y, radius * (1 - sin_cos(turned).cos), 1e-9);
  EXPECT_NEAR(wrap_angle(pose.theta - turned), 0.0, 1e-9);
  // The wheels' own circles; a tick is 0.15 mm.
  EXPECT_NEAR(rim_travel(rig, 0), turned * (radius - kTrack / 2), 1e-4);
  EXPECT_NEAR(rim_travel(rig, 1), turned * (radius + kTrack / 2), 1e-4);
  EXPECT_THROW(rig.sim.set_motor_duty(rig.robot, 1, 0.2), std::out_of_range);
}

TEST(Ackermann, SpeedsSharperThanItsLockDriveTheSharpestCurve) {
  EXPECT_NEAR(car().drive.max_curvature(), sharpest(), 1e-12);
  Rig rig(car());
  rig.sim.set_speed(rig.robot, {0.2, -4.0});
  rig.steps(100);
  EXPECT_NEAR(rig.sim.steering(rig.robot), -kLock, 1e-15);
  EXPECT_NEAR(rig.sim.twist(rig.robot).angular, -0.2 * sharpest(), 1e-12);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallNone);
}

TEST(Ackermann, ARampOfSpeedIsACircleFromItsFirstStep) {
  Rig rig(car());
  rig.sim.set_speed(rig.robot, {0.3, 0.6});
  rig.steps(100);
  const Pose pose = relative_to({2.0, 2.0, 0.0}, rig.sim.pose(rig.robot));
  // About (0, 0.5).
  EXPECT_NEAR(norm({pose.x, pose.y - 0.5}), 0.5, 1e-9);
}

TEST(Ackermann, ATurnOnTheSpotStandsStallsAndFails) {
  Rig rig(car());
  rig.sim.drive(rig.robot, {0.0, 1.0, 1.0});
  rig.steps(10);
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Driving);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth);
  EXPECT_NEAR(rig.sim.steering(rig.robot), kLock, 1e-15);
  rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Failed);
  EXPECT_EQ(rig.sim.pose(rig.robot), (Pose{2.0, 2.0, 0.0}));
  EXPECT_NEAR(rig.sim.time(), 2.0, 0.05);
  rig.sim.set_speed(rig.robot, {0.0, 1.0});
  rig.steps(10);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth);
  rig.sim.set_speed(rig.robot, {0.2, 0.0});
  rig.steps(10);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallNone);
}

TEST(Ackermann, AGoalThatIsTooSharpDrivesItsWayAndFails) {
  Rig rig(car());
  rig.sim.drive(rig.robot, {0.3, 3.0, 0.3});
  rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Failed);
  const double turned = 0.3 * sharpest();
  const Pose pose = rig.sim.pose(rig.robot);
  EXPECT_NEAR(pose.theta, turned, 1e-9);
  EXPECT_NEAR(pose.x - 2.0, sin_cos(turned).sin / sharpest(), 1e-9);
  // A goal at the very limit is possible.
  rig.sim.drive(rig.robot, {0.3, -0.3 * sharpest(), 0.3});
  rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  EXPECT_NEAR(rig.sim.pose(rig.robot).theta, 0.0, 1e-9);
}

TEST(Ackermann, TheCentreSwingsOutAheadOfTheRearAxle) {
  RobotModel model = car();
  model.drive.rear_axle = -0.08;
  Rig rig(model);
  rig.sim.drive(rig.robot, {0.6, 1.5, 0.3});
  rig.finish();
  const world::Arc arc = arc_of(PathStep{0.6, 1.5});
  // The rear axle drives the arc; the centre is 8 cm before it at both ends.
  const Vec2 wanted = Vec2{-0.08, 0.0} + arc.displacement + arc.turn.rotate({0.08, 0.0});
  const Pose pose = relative_to({2.0, 2.0, 0.0}, rig.sim.pose(rig.robot));
  EXPECT_NEAR(pose.x, wanted.x, 1e-9);
  EXPECT_NEAR(pose.y, wanted.y, 1e-9);
  EXPECT_NEAR(rig.sim.odometry(rig.robot).y, wanted.y, 1e-9);
}

TEST(Ackermann, TheSteeringTakesItsTime) {
  RobotModel model = car();
  model.drive.steering_speed = 0.5;
  Rig rig(model);
  rig.sim.set_steering(rig.robot, 0.4);
  rig.steps(30);
  EXPECT_NEAR(rig.sim.steering(rig.robot), 0.15, 1e-12);
  rig.steps(100);
  EXPECT_NEAR(rig.sim.steering(rig.robot), 0.4, 1e-12);
  // A curve from rest gets there all the same.
  rig.sim.set_odometry(rig.robot, {});
  rig.sim.drive(rig.robot, {1.0, -1.0, 0.3});
  rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  EXPECT_NEAR(rig.sim.odometry(rig.robot).theta, -1.0, deg_to_rad(1.1));
}

TEST(Ackermann, TheServoSteersFromLeftToRight) {
  RobotModel model = car();
  model.drive.steering_servo = 3;
  Rig rig(model);
  for (const auto& [position, angle] :
       {std::pair{0.0, kLock}, {0.5, 0.0}, {1.0, -kLock}, {0.25, kLock / 2}}) {
    rig.sim.set_servo(rig.robot, 3, position);
    rig.sim.step();
    EXPECT_NEAR(rig.sim.steering(rig.robot), angle, 1e-12);
    EXPECT_NEAR(rig.sim.servo(rig.robot, 3), position, 1e-12);
  }
  Rig other;
  EXPECT_THROW(other.sim.set_steering(other.robot, 0.1), std::out_of_range);
  EXPECT_EQ(other.sim.steering(other.robot), 0.0);
}

TEST(Ackermann, ModelsThatCannotBeAreRefused) {
  const auto refuses = [](auto change) {
    RobotModel model = car();
    change(model.drive);
    Simulation sim(room(4.0, 4.0), {});
    EXPECT_THROW(sim.add_robot(model, {2.0, 2.0, 0.0}), std::invalid_argument);
  };
  refuses([](DriveModel& drive) { drive.axle_distance = 0.0; });
  refuses([](DriveModel& drive) { drive.max_steering = kPi / 2; });
  refuses([](DriveModel& drive) { drive.max_steering = 0.0; });
  refuses([](DriveModel& drive) { drive.steering_speed = -1.0; });
  refuses([](DriveModel& drive) { drive.rear_axle = std::nan(""); });
  refuses([](DriveModel& drive) { drive.steering_servo = kServoCount; });
}

}  // namespace
}  // namespace eyebridge::robot
