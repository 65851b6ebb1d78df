// The central test, first part: what a robot senses, and what it must not be asked for.
// backend_contract_lidar_test.cpp has the scans, backend_contract_drive_test.cpp the movements.
#include "backend_contract.hpp"

#include <cmath>
#include <numeric>

#include <gmock/gmock.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/view.hpp"

namespace eyebridge::hal {
namespace {

INSTANTIATE_TEST_SUITE_P(AllBackends, BackendContract, testing::ValuesIn(all_rigs()),
                         [](const auto& rig) { return rig.param.name; });

TEST_P(BackendContract, FrontSensorSeesTheWallAhead) {
  for (const double wall : {0.12, 0.50, 0.80}) {
    const Rig rig = make(wall);
    const auto range = rig.backend->range_sensor(1)->read();
    ASSERT_TRUE(range) << range.error().what;
    EXPECT_NEAR(*range, wall, range_tolerance());
  }
}

TEST_P(BackendContract, SideSensorsLookToTheirSides) {
  const Rig rig = make(0.5);
  ASSERT_TRUE(rig.backend->world()->set_robot_pose(0, {1.0, 0.7, 0.0}));
  EXPECT_NEAR(rig.backend->range_sensor(2)->read().value(), 2 * kSideWall - 0.7, range_tolerance());
  EXPECT_NEAR(rig.backend->range_sensor(3)->read().value(), 0.7, range_tolerance());
}

TEST_P(BackendContract, RawReadingsAreWholeMillimetresInSimulation) {
  EXPECT_EQ(make(0.5).backend->range_sensor(1)->read_raw().value(), 500);
}

TEST_P(BackendContract, AWallBeyondReachReadsAsOutOfRange) {
  const Rig rig = make(kShortReach + 0.05);
  RangeSensor* sensor = rig.backend->range_sensor(4);
  EXPECT_EQ(sensor->read().value(), sensor->out_of_range());
  const Rig nearer = make(kShortReach - 0.05);
  EXPECT_NEAR(nearer.backend->range_sensor(4)->read().value(), kShortReach - 0.05,
              range_tolerance());
}

TEST_P(BackendContract, DevicesThatTheRobotLacksAreNull) {
  const Rig rig = make(0.5);
  for (const int id : {-1, 0, 5, 99}) {
    EXPECT_EQ(rig.backend->range_sensor(id), nullptr) << id;
    EXPECT_EQ(rig.backend->proximity(id), nullptr) << id;
    EXPECT_EQ(rig.backend->bumper(id), nullptr) << id;
    EXPECT_EQ(rig.backend->motor(id), nullptr) << id;
    EXPECT_EQ(rig.backend->encoder(id), nullptr) << id;
    EXPECT_EQ(rig.backend->servo(id), nullptr) << id;
  }
  EXPECT_EQ(rig.backend->motor(3), nullptr);
  EXPECT_EQ(rig.backend->servo(3), nullptr);
}

TEST_P(BackendContract, AskingAgainGivesTheSameDevice) {
  const Rig rig = make(0.5);
  ASSERT_NE(rig.backend->range_sensor(1), nullptr);
  EXPECT_EQ(rig.backend->range_sensor(1), rig.backend->range_sensor(1));
  EXPECT_NE(rig.backend->motor(1), rig.backend->motor(2));
}

TEST_P(BackendContract, ProximitySwitchesAtItsThreshold) {
  EXPECT_TRUE(make(kThreshold - 0.01).backend->proximity(1)->read().value());
  EXPECT_FALSE(make(kThreshold + 0.01).backend->proximity(1)->read().value());
}

TEST_P(BackendContract, BumperFeelsTheWallThatTheRobotRanInto) {
  const Rig rig = make(0.3);
  EXPECT_FALSE(rig.backend->bumper(1)->read().value());
  ASSERT_TRUE(rig.backend->drive()->set_speed({0.3, 0.0}));
  rig.wait(3.0);
  EXPECT_TRUE(rig.backend->bumper(1)->read().value());
}

TEST_P(BackendContract, CompassGivesTheHeadingInTheWorld) {
  const Rig rig = make(0.5);
  for (const double heading : {0.0, 1.0, -2.5, kPi}) {
    ASSERT_TRUE(rig.backend->world()->set_robot_pose(0, {1.0, 1.0, heading}));
    EXPECT_NEAR(rig.backend->compass()->read().value(), heading, 1e-9);
  }
}

TEST_P(BackendContract, ServosTurnTheCamera) {
  const Rig rig = make(0.5);
  camera::View* view = rig.backend->camera_view();
  ASSERT_NE(view, nullptr);
  const camera::Eye ahead = view->eye();
  EXPECT_NEAR(ahead.heading, 0.0, 1e-9);
  EXPECT_NEAR(ahead.pitch, 0.0, 1e-9);
  EXPECT_NEAR(ahead.x, 3.0 - 0.5 - kFrontOffset + rig_model().camera->x, 1e-9);

  ASSERT_TRUE(rig.backend->servo(1)->set(1.0));
  ASSERT_TRUE(rig.backend->servo(2)->set(0.25));
  EXPECT_NEAR(view->eye().heading, rig_model().camera->max_pan, 1e-9);
  EXPECT_NEAR(view->eye().pitch, -rig_model().camera->max_tilt / 2, 1e-9);
}

TEST_P(BackendContract, TheCameraMovesWithTheRobot) {
  const Rig rig = make(0.5);
  ASSERT_TRUE(rig.backend->world()->set_robot_pose(0, {1.0, 0.5, kPi / 2}));
  const camera::Eye eye = rig.backend->camera_view()->eye();
  EXPECT_NEAR(eye.x, 1.0, 1e-9);
  EXPECT_NEAR(eye.y, 0.5 + rig_model().camera->x, 1e-9);
  EXPECT_NEAR(eye.z, rig_model().camera->z, 1e-9);
  EXPECT_NEAR(eye.heading, kPi / 2, 1e-9);
}

TEST_P(BackendContract, TheCameraSeesAllBodiesAndKnowsItsCarrier) {
  const Rig rig = make(0.5);
  const world::Scene scene = rig.backend->camera_view()->scene();
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(scene.model->walls.size(), 5u);
  const std::uint32_t carrier = rig.backend->camera_view()->carrier();
  EXPECT_EQ(scene.bodies.at(carrier).pose, rig.backend->world()->robot_pose(0).value());
}

TEST_P(BackendContract, ArgumentsThatADeviceCannotTakeAreOutOfRange) {
  const Rig rig = make(0.5);
  const double nan = std::nan("");
  EXPECT_EQ(rig.backend->motor(1)->set_duty(1.01).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.backend->motor(1)->set_duty(nan).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.backend->motor(1)->set_speed(nan).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.backend->motor(1)->set_pid(4, 256, 1).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.backend->servo(1)->set(-0.01).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.backend->drive()->set_speed({nan, 0.0}).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.backend->drive()->start({1.0, nan, 0.1}).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.backend->drive()->start({1.0, 0.0, -0.1}).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.backend->drive()->set_odometry({nan, 0.0, 0.0}).error().code, Errc::OutOfRange);
}

TEST_P(BackendContract, WorldControlCountsFromOneAndKnowsItsOwnRobotAsZero) {
  const Rig rig = make(0.5);
  WorldControl* world = rig.backend->world();
  EXPECT_EQ(rig.backend->robot_id(), 1);
  EXPECT_EQ(world->robot_count(), 2);
  EXPECT_EQ(world->object_count(), 1);
  EXPECT_EQ(world->robot_pose(0).value(), world->robot_pose(1).value());
  EXPECT_NEAR(world->robot_pose(2).value().y, 1.5, 1e-9);
  EXPECT_NEAR(world->object_pose(1).value().y, 0.5, 1e-9);
}

TEST_P(BackendContract, WorldControlRefusesUnknownIdsAndPoses) {
  const Rig rig = make(0.5);
  WorldControl* world = rig.backend->world();
  EXPECT_EQ(world->robot_pose(3).error().what, "no robot 3, the world has 2");
  EXPECT_EQ(world->robot_pose(-1).error().code, Errc::OutOfRange);
  EXPECT_EQ(world->object_pose(0).error().what, "no object 0, the world has 1");
  EXPECT_EQ(world->set_object_pose(2, {}).error().code, Errc::OutOfRange);
  EXPECT_EQ(world->set_robot_pose(1, {std::nan(""), 0, 0}).error().code, Errc::OutOfRange);
}

TEST_P(BackendContract, WorldControlMovesObjectsIntoSight) {
  const Rig rig = make(0.5);
  ASSERT_TRUE(rig.backend->world()->set_object_pose(1, {3.0 - 0.3, kSideWall, 0.0}));
  EXPECT_NEAR(front(rig), 0.2 - world::ObjectSpec{}.radius, range_tolerance());
}

TEST_P(BackendContract, TheClockStartsNearZeroAndNeverRunsBackwards) {
  const Rig rig = make(0.5);
  Clock& clock = rig.backend->clock();
  EXPECT_GE(clock.now(), Time(0));
  Time last = clock.now();
  for (int i = 0; i < 50; ++i) {
    const Time deadline = last + from_seconds(0.013);
    clock.wait_until(deadline);
    clock.spend(from_seconds(0.0005));
    EXPECT_GE(clock.now(), deadline);
    last = clock.now();
  }
}

}  // namespace
}  // namespace eyebridge::hal
