#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "rig.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kNear = 0.2;  // metres from the robot's rim to the wall in front of it

Rig facing_wall(const RobotModel& model = {}) {
  return Rig(model, {4.0 - model.radius() - kNear, 2.0, 0.0});
}

TEST(Stall, GoalIntoAWallStopsThereAndFailsAfterTheTimeOut) {
  Rig rig = facing_wall();
  rig.sim.drive(rig.robot, {1.0, 0.0, 0.3});
  while (rig.sim.stalled(rig.robot) == kStallNone) rig.sim.step();
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth);
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Driving);
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, 4.0 - 0.093, 1e-6);
  const int steps = rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Failed);
  EXPECT_EQ(steps, 199) << "the first stalled step counts";
  EXPECT_EQ(rig.sim.twist(rig.robot), Twist{});
  rig.steps(10);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth) << "until the next command";
}

TEST(Stall, WheelsCountOnlyTheWayTheRobotWent) {
  Rig rig = facing_wall();
  rig.sim.drive(rig.robot, {1.0, 0.0, 0.3});
  rig.finish();
  EXPECT_NEAR(rig.sim.odometry(rig.robot).x, kNear, 1e-6);
  RobotModel model;
  const double ticks = kNear / (kPi * model.drive.wheel_diameter) * 1100;
  EXPECT_NEAR(static_cast<double>(rig.sim.encoder_ticks(rig.robot, 0)), ticks, 1.0);
}

TEST(Stall, ANewCommandEndsIt) {
  Rig rig = facing_wall();
  rig.sim.drive(rig.robot, {1.0, 0.0, 0.3});
  rig.finish();
  rig.sim.drive(rig.robot, {-0.5, 0.0, 0.3});
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallNone);
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Driving);
  rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  EXPECT_NEAR(rig.sim.odometry(rig.robot).x, kNear - 0.5, 1e-6);
}

TEST(Stall, RobotDrivesOnWithARampWhenTheObstacleLeaves) {
  Rig rig({}, {1.0, 2.0, 0.0});
  const RobotIndex other = rig.sim.add_robot({}, {1.5, 2.0, 0.0});
  rig.sim.drive(rig.robot, {1.0, 0.0, 0.3});
  while (rig.sim.stalled(rig.robot) == kStallNone) rig.sim.step();
  rig.steps(100);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth);
  rig.sim.set_pose(other, {1.0, 3.0, 0.0});
  rig.steps(1);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallNone);
  EXPECT_LE(rig.sim.twist(rig.robot).linear, 0.01 + 1e-9) << "no jump";
  rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, 2.0, 1e-9);
}

TEST(Stall, AGoalThatFailedDoesNotGoOnWhenTheObstacleLeaves) {
  Rig rig({}, {1.0, 2.0, 0.0});
  const RobotIndex other = rig.sim.add_robot({}, {1.5, 2.0, 0.0});
  rig.sim.drive(rig.robot, {1.0, 0.0, 0.3});
  rig.finish();
  ASSERT_EQ(rig.sim.drive_state(rig.robot), DriveState::Failed);
  rig.steps(10);
  const Pose there = rig.sim.pose(rig.robot);
  rig.sim.set_pose(other, {1.0, 3.0, 0.0});
  rig.steps(10);
  EXPECT_EQ(rig.sim.pose(rig.robot), there);
}

TEST(Stall, SpeedModeKeepsTrying) {
  Rig rig = facing_wall();
  rig.sim.set_speed(rig.robot, {0.3, 0.0});
  rig.steps(1000);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth);
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
}

TEST(Stall, MotorsStallToo) {
  for (const double time_constant : {0.0, 0.1}) {
    RobotModel model;
    model.drive.motor_time_constant = time_constant;
    Rig rig = facing_wall(model);
    rig.sim.set_motor_speed(rig.robot, 0, 1500.0);
    rig.sim.set_motor_speed(rig.robot, 1, 1500.0);
    rig.steps(500);
    EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth);
    const std::int64_t ticks = rig.sim.encoder_ticks(rig.robot, 1);
    rig.steps(100);
    EXPECT_EQ(rig.sim.encoder_ticks(rig.robot, 1), ticks);
  }
}

TEST(Stall, TurningOnTheSpotAtAWallIsFree) {
  Rig rig = facing_wall();
  rig.sim.drive(rig.robot, {1.0, 0.0, 0.3});
  rig.finish();
  rig.sim.drive(rig.robot, {0.0, kPi, 2.0});
  rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallNone);
  EXPECT_NEAR(std::abs(rig.sim.pose(rig.robot).theta), kPi, 1e-9);
}

TEST(Collision, IsReportedOnceAContact) {
  Rig rig = facing_wall();
  std::vector<CollisionEvent> events;
  rig.sim.on_collision([&](const CollisionEvent& event) { events.push_back(event); });
  rig.sim.set_speed(rig.robot, {0.3, 0.0});
  rig.steps(500);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_TRUE(events[0].with_wall());
  EXPECT_EQ(events[0].robot, rig.robot);
  EXPECT_NEAR(events[0].pose.x, 4.0 - 0.093, 1e-6);
  // The ramp to 0.3 m/s takes 0.3 s and 45 mm; the rest of the way is driven at that speed.
  EXPECT_NEAR(events[0].time, 0.3 + (kNear - 0.045) / 0.3, 0.025);

  rig.sim.drive(rig.robot, {0.0, 0.3, 1.0});
  rig.finish();
  rig.sim.set_speed(rig.robot, {0.3, 0.0});
  rig.steps(100);
  EXPECT_EQ(events.size(), 1u) << "it turned on the spot, but never left the wall";

  rig.sim.drive(rig.robot, {-0.1, 0.0, 0.3});
  rig.finish();
  rig.sim.set_speed(rig.robot, {0.3, 0.0});
  rig.steps(200);
  EXPECT_EQ(events.size(), 2u) << "free in between";
}

}  // namespace
}  // namespace eyebridge::robot
