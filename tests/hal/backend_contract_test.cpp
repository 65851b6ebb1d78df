// The central test, first part: what a robot senses, and what it must not be asked for.
// backend_contract_world_test.cpp has the world around it, backend_contract_lidar_test.cpp the
// scans, backend_contract_drive_test.cpp and backend_contract_motor_test.cpp the movements.
#include "backend_contract.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

INSTANTIATE_TEST_SUITE_P(AllBackends, BackendContract, testing::ValuesIn(contract_rows()),
                         [](const auto& rig) { return rig.param.name; });

TEST_P(BackendContract, FrontSensorSeesTheWallAhead) {
  for (const double wall : {0.12, 0.50, 0.80}) {
    const Rig rig = make(wall);
    const auto range = rig.backend->range_sensor(1)->read();
    ASSERT_TRUE(range) << range.error().what;
    EXPECT_NEAR(*range, wall, traits().range);
  }
}

TEST_P(BackendContract, SideSensorsLookToTheirSides) {
  const Rig rig = make_at({1.0, 0.7, 0.0});
  EXPECT_NEAR(must(rig.backend->range_sensor(2)->read()), 2 * kSideWall - 0.7, traits().range);
  EXPECT_NEAR(must(rig.backend->range_sensor(3)->read()), 0.7, traits().range);
}

TEST_P(BackendContract, RawReadingsAreWhatTheSensorGives) {
  EXPECT_EQ(must(make(0.5).backend->range_sensor(1)->read_raw()), traits().raw_at_half_metre);
}

TEST_P(BackendContract, AWallBeyondReachReadsAsOutOfRange) {
  const Rig rig = make(kShortReach + 0.05);
  RangeSensor* sensor = rig.backend->range_sensor(4);
  EXPECT_EQ(must(sensor->read()), sensor->out_of_range());
  const Rig nearer = make(kShortReach - 0.05);
  EXPECT_NEAR(must(nearer.backend->range_sensor(4)->read()), kShortReach - 0.05, traits().range);
}

TEST_P(BackendContract, DevicesThatTheRobotLacksAreNull) {
  const Rig rig = make(0.5);
  for (const int id : {-1, 0, 5, 99}) {
    EXPECT_EQ(rig.backend->range_sensor(id), nullptr) << id;
    EXPECT_EQ(rig.backend->proximity(id), nullptr) << id;
    EXPECT_EQ(rig.backend->bumper(id), nullptr) << id;
    EXPECT_EQ(rig.backend->motor(id), nullptr) << id;
    EXPECT_EQ(rig.backend->encoder(id), nullptr) << id;
  }
  for (const int id : {-1, 0, 15, 99}) EXPECT_EQ(rig.backend->servo(id), nullptr) << id;
  EXPECT_EQ(rig.backend->motor(traits().motors + 1), nullptr);
  EXPECT_EQ(rig.backend->encoder(traits().motors + 1), nullptr);
  EXPECT_EQ(rig.backend->servo(traits().servos + 1), nullptr);
}

TEST_P(BackendContract, DevicesThatTheRobotHasAreThere) {
  const Rig rig = make(0.5);
  EXPECT_NE(rig.backend->drive(), nullptr);
  for (int id = 1; id <= 4; ++id) EXPECT_NE(rig.backend->range_sensor(id), nullptr) << id;
  for (int id = 1; id <= traits().motors; ++id) {
    EXPECT_NE(rig.backend->motor(id), nullptr) << id;
    EXPECT_NE(rig.backend->encoder(id), nullptr) << id;
  }
  for (int id = 1; id <= traits().servos; ++id) EXPECT_NE(rig.backend->servo(id), nullptr) << id;
  EXPECT_EQ(rig.backend->proximity(1) != nullptr, traits().switches);
  EXPECT_EQ(rig.backend->bumper(1) != nullptr, traits().switches);
  EXPECT_EQ(rig.backend->compass() != nullptr, traits().compass);
  EXPECT_EQ(rig.backend->gyroscope() != nullptr, traits().inertial);
  EXPECT_EQ(rig.backend->accelerometer() != nullptr, traits().inertial);
  EXPECT_EQ(rig.backend->lidar() != nullptr, traits().lidar != Lidars::None);
  EXPECT_EQ(rig.backend->world() != nullptr, traits().world);
  EXPECT_EQ(rig.backend->camera_view() != nullptr, traits().world);
}

TEST_P(BackendContract, AskingAgainGivesTheSameDevice) {
  const Rig rig = make(0.5);
  ASSERT_NE(rig.backend->range_sensor(1), nullptr);
  EXPECT_EQ(rig.backend->range_sensor(1), rig.backend->range_sensor(1));
  EXPECT_NE(rig.backend->motor(1), rig.backend->motor(2));
}

TEST_P(BackendContract, ProximitySwitchesAtItsThreshold) {
  for (const double distance : {kThreshold - 0.01, kThreshold + 0.01}) {
    const Rig rig = make(distance);
    SwitchSensor* proximity = rig.backend->proximity(1);
    ASSERT_EQ(proximity != nullptr, traits().switches);
    if (proximity == nullptr) continue;
    EXPECT_EQ(must(proximity->read()), distance < kThreshold);
  }
}

TEST_P(BackendContract, BumperFeelsTheWallThatTheRobotRanInto) {
  const Rig rig = make(0.3);
  SwitchSensor* bumper = rig.backend->bumper(1);
  ASSERT_EQ(bumper != nullptr, traits().switches);
  if (bumper == nullptr) return;
  EXPECT_FALSE(must(bumper->read()));
  ASSERT_TRUE(rig.backend->drive()->set_speed({0.3, 0.0}));
  rig.wait(3.0);
  EXPECT_TRUE(must(bumper->read()));
}

TEST_P(BackendContract, CompassGivesTheHeadingInTheWorld) {
  for (const double heading : {0.0, 1.0, -2.5, kPi}) {
    const Rig rig = make_at({1.0, 1.0, heading});
    Compass* compass = rig.backend->compass();
    ASSERT_EQ(compass != nullptr, traits().compass);
    if (compass == nullptr) continue;
    EXPECT_NEAR(must(compass->read()), heading, 1e-9);
  }
}

TEST_P(BackendContract, GyroscopeAndAccelerometerFeelACurve) {
  const Rig rig = make(0.8);
  Gyroscope* gyroscope = rig.backend->gyroscope();
  Accelerometer* accelerometer = rig.backend->accelerometer();
  ASSERT_EQ(gyroscope != nullptr, traits().inertial);
  ASSERT_EQ(accelerometer != nullptr, traits().inertial);
  if (gyroscope == nullptr || accelerometer == nullptr) return;
  EXPECT_EQ(must(gyroscope->read()), 0.0);
  EXPECT_EQ(must(accelerometer->read()), Vec2{});
  ASSERT_TRUE(rig.backend->drive()->set_speed({0.2, -1.0}));
  rig.wait(1.0);  // it has its speed
  EXPECT_NEAR(must(gyroscope->read()), -1.0, traits().angular);
  const Vec2 felt = must(accelerometer->read());
  EXPECT_NEAR(felt.x, 0.0, 1e-6);
  // What holds it on its curve, speed times rate of turn, is on the right.
  EXPECT_NEAR(felt.y, -0.2, traits().angular);
}

TEST_P(BackendContract, ServosTurnTheCamera) {
  const Rig rig = make(0.5);
  if (traits().servos == 0) return;  // null: see DevicesThatTheRobotLacksAreNull
  ASSERT_TRUE(rig.backend->servo(1)->set(1.0));
  ASSERT_TRUE(rig.backend->servo(2)->set(0.25));
  rig.wait(0.1);
  if (!rig.truth) return;
  EXPECT_NEAR(rig.truth().pan, rig_model().camera->max_pan, traits().servo);
  EXPECT_NEAR(rig.truth().tilt, -rig_model().camera->max_tilt / 2, traits().servo);
  ASSERT_TRUE(rig.backend->servo(1)->set(0.0));
  rig.wait(0.1);
  EXPECT_NEAR(rig.truth().pan, -rig_model().camera->max_pan, traits().servo);
  EXPECT_NEAR(rig.truth().tilt, -rig_model().camera->max_tilt / 2, traits().servo);
}

TEST_P(BackendContract, ArgumentsThatADeviceCannotTakeAreOutOfRange) {
  const Rig rig = make(0.5);
  const double nan = std::nan("");
  EXPECT_EQ(rig.backend->motor(1)->set_duty(1.01).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.backend->motor(1)->set_duty(nan).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.backend->motor(1)->set_speed(nan).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.backend->motor(1)->set_pid(4, 256, 1).error().code, Errc::OutOfRange);
  if (traits().servos > 0) {
    EXPECT_EQ(rig.backend->servo(1)->set(-0.01).error().code, Errc::OutOfRange);
  }
  EXPECT_EQ(rig.backend->drive()->set_speed({nan, 0.0}).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.backend->drive()->start({1.0, nan, 0.1}).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.backend->drive()->start({1.0, 0.0, -0.1}).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.backend->drive()->set_odometry({nan, 0.0, 0.0}).error().code, Errc::OutOfRange);
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
