#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "rig.hpp"

namespace eyebridge::robot {
namespace {

RobotModel with_eyes() {
  RobotModel model;
  RangeSensorModel ahead;
  ahead.max_range = 10.0;
  model.range_sensors = {ahead};
  return model;
}

TEST(RobotRemoval, FreesTheWayOfWhoWasHeldByIt) {
  Rig rig({}, {1.0, 2.0, 0.0});
  const RobotIndex other = rig.sim.add_robot({}, {1.5, 2.0, 0.0});
  rig.sim.set_speed(rig.robot, {0.3, 0.0});
  rig.steps(300);
  ASSERT_EQ(rig.sim.stalled(rig.robot), kStallBoth);
  rig.sim.remove_robot(other);
  rig.steps(300);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallNone);
  EXPECT_GT(rig.sim.pose(rig.robot).x, 1.8);
  EXPECT_EQ(rig.sim.collision_count(), 1u) << "with whom it met before";
}

TEST(RobotRemoval, NobodySensesIt) {
  Rig rig(with_eyes(), {1.0, 2.0, 0.0});
  const double alone = rig.sim.true_range(rig.robot, 0);
  const RobotIndex other = rig.sim.add_robot({}, {1.5, 2.0, 0.0});
  ASSERT_LT(rig.sim.true_range(rig.robot, 0), alone);
  rig.sim.remove_robot(other);
  EXPECT_EQ(rig.sim.true_range(rig.robot, 0), alone);
  EXPECT_EQ(rig.sim.read_range(rig.robot, 0), alone);
}

class RemovalOf : public ::testing::TestWithParam<DriveKind> {};

TEST_P(RemovalOf, StopsItWhateverItIsTold) {
  RobotModel model;
  model.drive.kind = GetParam();
  model.drive.axle_distance = 0.16;
  model.drive.motor_time_constant = 0.2;  // wheels that would roll on
  Rig rig(model, {1.0, 1.0, 0.0});
  rig.sim.set_speed(rig.robot, {0.3, 0.0});
  rig.steps(200);
  const Pose last = rig.sim.pose(rig.robot);
  rig.sim.remove_robot(rig.robot);
  EXPECT_FALSE(rig.sim.is_there(rig.robot));
  EXPECT_EQ(rig.sim.twist(rig.robot), Twist{});
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  rig.sim.set_speed(rig.robot, {0.3, 0.5});
  rig.steps(10);
  rig.sim.set_motor_duty(rig.robot, 0, 1.0);
  rig.steps(10);
  rig.sim.set_pose(rig.robot, {2.0, 2.0, 1.0});
  rig.steps(10);
  EXPECT_EQ(rig.sim.pose(rig.robot), last);
  EXPECT_EQ(rig.sim.twist(rig.robot), Twist{});
  EXPECT_EQ(rig.sim.body_twist(rig.robot), HolonomicTwist{});
  EXPECT_EQ(rig.sim.read_accelerometer(rig.robot), Vec2{});
}

INSTANTIATE_TEST_SUITE_P(Drives, RemovalOf,
                         ::testing::Values(DriveKind::Differential, DriveKind::Ackermann,
                                           DriveKind::Omni, DriveKind::Swedish, DriveKind::Synchro,
                                           DriveKind::Submarine));

TEST(RobotRemoval, NobodyHearsItsSonar) {
  RobotModel model;
  model.range_sensors.emplace_back().kind = RangeKind::Ultrasound;
  Rig rig(model, {1.0, 2.0, 0.0});
  const RobotIndex other = rig.sim.add_robot(model, {2.0, 2.0, kPi});
  ASSERT_EQ(rig.sim.cross_talkers(rig.robot, 0), 1u);
  rig.sim.remove_robot(other);
  EXPECT_EQ(rig.sim.cross_talkers(rig.robot, 0), 0u);
}

TEST(RobotRemoval, LeavesTheOthersAsTheyAre) {
  Rig rig({}, {1.0, 1.0, 0.0});
  Rig whole({}, {1.0, 1.0, 0.0});
  for (Rig* each : {&rig, &whole}) {
    const RobotIndex far = each->sim.add_robot({}, {3.0, 3.0, 0.0});
    const RobotIndex third = each->sim.add_robot({}, {1.0, 3.0, 0.0});
    for (const RobotIndex robot : {each->robot, third}) each->sim.set_speed(robot, {0.1, 0.3});
    each->steps(50);
    if (each == &rig) each->sim.remove_robot(far);
    each->steps(200);
  }
  EXPECT_EQ(rig.sim.robot_count(), 3u);
  EXPECT_EQ(rig.sim.pose(0), whole.sim.pose(0));
  EXPECT_EQ(rig.sim.pose(2), whole.sim.pose(2));
  EXPECT_NE(rig.sim.state_hash(), whole.sim.state_hash());
  EXPECT_EQ(rig.sim.add_robot({}, {3.0, 3.0, 0.0}), 3u);
  EXPECT_THROW(rig.sim.remove_robot(4), std::out_of_range);
}

}  // namespace
}  // namespace eyebridge::robot
