#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "errors.hpp"
#include "eyebridge/base/random.hpp"
#include "rig.hpp"

namespace eyebridge::robot {
namespace {

RangeSensorModel psd(double bearing) {
  RangeSensorModel sensor;
  const Heading heading = Heading::from_angle(bearing);
  sensor.pose_in_robot = {0.05 * heading.cos, 0.05 * heading.sin, bearing};
  return sensor;
}

TEST(RangeSensor, MeasuresFromItsFaceToTheWall) {
  RobotModel model;
  model.range_sensors = {psd(0.0), psd(kPi / 2), psd(-kPi / 2), psd(kPi)};
  Rig rig(model, {3.0, 1.5, kPi / 2});
  EXPECT_NEAR(rig.sim.read_range(rig.robot, 0), 4.0 - 1.5 - 0.05, 1e-9) << "north";
  EXPECT_NEAR(rig.sim.read_range(rig.robot, 1), 3.0 - 0.05, 1e-9) << "west";
  EXPECT_NEAR(rig.sim.read_range(rig.robot, 2), 1.0 - 0.05, 1e-9) << "east";
  EXPECT_NEAR(rig.sim.read_range(rig.robot, 3), 1.5 - 0.05, 1e-9) << "south";
}

TEST(RangeSensor, OutsideItsLimitsReadsOutOfRange) {
  RobotModel model;
  model.range_sensors = {psd(0.0)};
  model.range_sensors[0].min_range = 0.1;
  model.range_sensors[0].max_range = 0.8;
  Rig rig(model);
  EXPECT_EQ(rig.sim.read_range(rig.robot, 0), 9.999) << "too far";
  rig.sim.set_pose(rig.robot, {3.3, 2.0, 0.0});
  EXPECT_NEAR(rig.sim.read_range(rig.robot, 0), 0.65, 1e-9);
  rig.sim.set_pose(rig.robot, {3.9, 2.0, 0.0});
  EXPECT_EQ(rig.sim.read_range(rig.robot, 0), 9.999) << "too near";
}

TEST(RangeSensor, ItsTruthHasNoErrorAndDrawsNothing) {
  RobotModel model;
  model.range_sensors = {psd(0.0), psd(kPi)};
  model.range_sensors[0].error = {{0.1, 0.02, 0.0}};
  model.range_sensors[1].max_range = 0.5;
  Rig asked(model);
  Rig unasked(model);
  EXPECT_NEAR(asked.sim.true_range(asked.robot, 0), 1.95, 1e-9);
  EXPECT_EQ(asked.sim.true_range(asked.robot, 1), 9.999) << "out of range";
  EXPECT_EQ(asked.sim.read_range(asked.robot, 0), unasked.sim.read_range(unasked.robot, 0));
}

/// `place(i)` is the pose of sensor i.
template <class Place>
void expect_one_by_one(Place place) {
  RobotModel model;
  for (int i = 0; i < 30; ++i) {
    RangeSensorModel psd;
    psd.pose_in_robot = place(i);
    psd.max_range = psd.out_of_range = i % 7 == 0 ? 1.5 : 4.0;
    psd.min_range = 0.2;
    if (i % 3 == 0) psd.error = {{0.01, 0.02, 0.03}};
    model.range_sensors.push_back(psd);
  }
  Rig together(model, {1.0, 1.5, 0.3});
  Rig apart(model, {1.0, 1.5, 0.3});
  for (Rig* rig : {&together, &apart}) rig->sim.add_robot({}, {1.4, 1.4, 0.0});
  std::vector<double> ranges(model.range_sensors.size());
  for (int step = 0; step < 20; ++step) {
    together.sim.read_ranges(together.robot, ranges);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      ASSERT_EQ(ranges[i], apart.sim.read_range(apart.robot, i)) << "sensor " << i;
    }
  }
  EXPECT_THROW(together.sim.read_ranges(together.robot, std::span(ranges).first(3)),
               std::out_of_range);
}

TEST(RangeSensor, AllAtOnceReadAsOneByOne) {
  Random random(7);
  const auto turn = [&] { return 2 * kPi * random.uniform(); };
  // From few places; from anywhere upon the robot; from farther apart than are cast at once.
  expect_one_by_one([&](int i) { return Pose{i < 20 ? 0.0 : 0.05, i < 24 ? 0.0 : -0.02, turn()}; });
  for (const double size : {1e-12, 0.1, 0.9}) {
    expect_one_by_one([&](int) {
      return Pose{size * (random.uniform() - 0.5), size * (random.uniform() - 0.5), turn()};
    });
  }
}

TEST(RangeSensor, SeesOtherRobotsButNotItself) {
  RobotModel model;
  model.range_sensors = {psd(0.0)};
  Rig rig(model, {1.0, 2.0, 0.0});
  rig.sim.add_robot({}, {2.0, 2.0, 0.0});
  EXPECT_NEAR(rig.sim.read_range(rig.robot, 0), 1.0 - 0.05 - 0.093, 1e-9);
}

TEST(Proximity, IsTrueNearerThanItsThreshold) {
  RobotModel model;
  ProximityModel sensor;
  sensor.threshold = 0.15;
  model.proximity_sensors = {sensor};
  Rig rig(model, {4.0 - 0.16, 2.0, 0.0});
  EXPECT_FALSE(rig.sim.read_proximity(rig.robot, 0));
  rig.sim.set_pose(rig.robot, {4.0 - 0.149, 2.0, 0.0});
  EXPECT_TRUE(rig.sim.read_proximity(rig.robot, 0));
}

TEST(Proximity, FlipsAsOftenAsItWasTold) {
  RobotModel model;
  ProximityModel sensor;
  sensor.error.flip = 0.1;
  model.proximity_sensors = {sensor};
  Rig rig(model);
  int wrong = 0;
  for (int i = 0; i < 10000; ++i) wrong += rig.sim.read_proximity(rig.robot, 0) ? 1 : 0;
  EXPECT_NEAR(wrong, 1000, 120);
}

std::array<bool, 4> bumpers_at_wall(double heading) {
  RobotModel model;
  for (const double middle : {0.0, 90.0, 180.0, 270.0}) {  // front, left, back, right
    BumperModel bumper;
    bumper.start = deg_to_rad(middle - 45);
    bumper.end = deg_to_rad(middle + 45);
    model.bumpers.push_back(bumper);
  }
  Rig rig(model, {4.0 - model.radius() - 1e-4, 2.0, heading});
  std::array<bool, 4> touched{};
  for (std::size_t i = 0; i < 4; ++i) touched[i] = rig.sim.read_bumper(rig.robot, i);
  return touched;
}

TEST(Bumper, TellsOnWhichSideTheWallIs) {
  EXPECT_EQ(bumpers_at_wall(0.0), (std::array{true, false, false, false}));
  EXPECT_EQ(bumpers_at_wall(-kPi / 2), (std::array{false, true, false, false}));
  EXPECT_EQ(bumpers_at_wall(kPi), (std::array{false, false, true, false}));
  EXPECT_EQ(bumpers_at_wall(kPi - 0.5), (std::array{false, false, true, false}));
  EXPECT_EQ(bumpers_at_wall(-kPi + 0.5), (std::array{false, false, true, false}));
  EXPECT_EQ(bumpers_at_wall(kPi / 2), (std::array{false, false, false, true}));
}

TEST(Bumper, IsOpenAwayFromEverything) {
  RobotModel model;
  model.bumpers = {{1, "ring", 0.0, 2 * kPi, {0.0}}};
  Rig rig(model, {4.0 - model.radius() - 0.01, 2.0, 0.0});
  EXPECT_FALSE(rig.sim.read_bumper(rig.robot, 0));
}

TEST(Bumper, MissesAsOftenAsItWasTold) {
  RobotModel model;
  model.bumpers = {{1, "ring", 0.0, 2 * kPi, {0.25}}};
  Rig rig(model, {4.0 - model.radius() - 1e-4, 2.0, 0.0});
  int seen = 0;
  for (int i = 0; i < 4000; ++i) seen += rig.sim.read_bumper(rig.robot, 0) ? 1 : 0;
  EXPECT_NEAR(seen, 3000, 120);
}

TEST(Lidar, FullCircleStartsBehindAndGoesByTheLeft) {
  RobotModel model;
  model.lidar = LidarModel{};
  Rig rig(model, {1.0, 1.5, 0.0});
  std::vector<double> ranges(360);
  rig.sim.read_lidar(rig.robot, 2 * kPi, ranges);
  EXPECT_NEAR(ranges[0], 1.0, 1e-9) << "behind";
  EXPECT_NEAR(ranges[90], 2.5, 1e-9) << "left";
  EXPECT_NEAR(ranges[180], 3.0, 1e-9) << "front";
  EXPECT_NEAR(ranges[270], 1.5, 1e-9) << "right";
}

TEST(Lidar, TurnsWithTheRobotAndSitsWhereItsModelSays) {
  RobotModel model;
  model.lidar = LidarModel{};
  model.lidar->pose_in_robot = {0.1, 0.0, 0.0};
  Rig rig(model, {1.0, 1.5, kPi / 2});
  std::vector<double> ranges(360);
  rig.sim.read_lidar(rig.robot, 2 * kPi, ranges);
  EXPECT_NEAR(ranges[180], 2.4, 1e-9) << "front, north";
  EXPECT_NEAR(ranges[90], 1.0, 1e-9) << "left, west";
}

TEST(Lidar, PartialScanRunsFromLeftToRight) {
  RobotModel model;
  model.lidar = LidarModel{};
  Rig rig(model, {1.0, 1.5, 0.0});
  std::vector<double> ranges(3);
  rig.sim.read_lidar(rig.robot, kPi, ranges);
  EXPECT_NEAR(ranges[0], 2.5, 1e-9);
  EXPECT_NEAR(ranges[1], 3.0, 1e-9);
  EXPECT_NEAR(ranges[2], 1.5, 1e-9);
}

TEST(Lidar, NothingInReachReadsItsReach) {
  RobotModel model;
  model.lidar = LidarModel{};
  model.lidar->max_range = 0.7;
  model.lidar->error.sigma = 0.01;
  Rig rig(model);
  std::vector<double> ranges(8);
  rig.sim.read_lidar(rig.robot, 2 * kPi, ranges);
  EXPECT_EQ(ranges, std::vector<double>(8, 0.7));
}

TEST(Lidar, TiltedDownItSeesTheFloor) {
  RobotModel model;
  model.lidar = LidarModel{};
  Rig rig(model);
  std::vector<double> ranges(4);
  rig.sim.read_lidar(rig.robot, 2 * kPi, deg_to_rad(30), ranges);
  for (const double range : ranges) EXPECT_NEAR(range, 0.2, 1e-9);
}

TEST(Lidar, ErrorsSpreadTheReadings) {
  RobotModel model;
  model.lidar = LidarModel{};
  model.lidar->error = {{0.1, 0.02, 0.0}};
  Rig rig(model);
  std::vector<double> ranges(1);
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kCount = 5000;
  for (int i = 0; i < kCount; ++i) {
    rig.sim.read_lidar(rig.robot, 1.0, ranges);
    sum += ranges[0] - 2.0;
    squares += (ranges[0] - 2.0) * (ranges[0] - 2.0);
  }
  const double mean = sum / kCount;
  EXPECT_NEAR(mean, 0.1, 0.002);
  EXPECT_NEAR(std::sqrt(squares / kCount - mean * mean), 0.02, 0.001);
}

TEST(Compass, ReadsTheHeading) {
  Rig rig({}, {2.0, 2.0, -2.5});
  EXPECT_NEAR(rig.sim.read_compass(rig.robot), -2.5, 1e-12);
}

TEST(Compass, ErrorIsWrapped) {
  RobotModel model;
  model.compass_error.bias = 0.2;
  Rig rig(model, {2.0, 2.0, kPi - 0.1});
  EXPECT_NEAR(rig.sim.read_compass(rig.robot), -kPi + 0.1, 1e-12);
}

TEST(Servo, StartsInTheMiddleAndIsClamped) {
  Rig rig;
  EXPECT_EQ(rig.sim.servo(rig.robot, 0), 0.5);
  rig.sim.set_servo(rig.robot, 0, 0.75);
  rig.sim.set_servo(rig.robot, 1, 7.0);
  EXPECT_EQ(rig.sim.servo(rig.robot, 0), 0.75);
  EXPECT_EQ(rig.sim.servo(rig.robot, 1), 1.0);
}

TEST(Devices, ThatARobotLacksAreOutOfRange) {
  Rig rig;
  EXPECT_THROW(rig.sim.set_servo(rig.robot, kServoCount, 0.5), std::out_of_range);
  EXPECT_THROW(static_cast<void>(rig.sim.servo(rig.robot, kServoCount)), std::out_of_range);
  EXPECT_THROW(rig.sim.set_motor_duty(rig.robot, 2, 0.5), std::out_of_range);
  EXPECT_THROW(rig.sim.set_motor_speed(rig.robot, 2, 10.0), std::out_of_range);
  EXPECT_THROW(rig.sim.set_motor_pid(rig.robot, 2, 1, 1, 1), std::out_of_range);
  EXPECT_THROW(static_cast<void>(rig.sim.encoder_ticks(rig.robot, 2)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(rig.sim.read_range(rig.robot, 0)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(rig.sim.true_range(rig.robot, 0)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(rig.sim.read_proximity(rig.robot, 0)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(rig.sim.read_bumper(rig.robot, 0)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(rig.sim.pose(rig.robot + 1)), std::out_of_range);
  double range = 0.0;
  EXPECT_THROW(rig.sim.read_lidar(rig.robot, 1.0, {&range, 1}), std::bad_optional_access);
}

TEST(CameraNoise, HasAStreamOfItsOwn) {
  Rig rig;
  const RobotIndex second = rig.sim.add_robot({}, {1.0, 1.0, 0.0});
  const std::uint64_t seed = rig.sim.camera_noise_seed(rig.robot);
  EXPECT_EQ(seed, rig.sim.camera_noise_seed(rig.robot));
  EXPECT_NE(seed, rig.sim.camera_noise_seed(second));
  SimulationSettings other;
  other.seed = 2;
  const Rig reseeded({}, {2.0, 2.0, 0.0}, other);
  EXPECT_NE(seed, reseeded.sim.camera_noise_seed(0));
  // Frame 0, 1, … of the camera against the streams of the robot's other devices.
  for (std::uint64_t time = 0; time < 3; ++time) {
    const std::uint64_t snow = Random(seed, time).bits();
    for (const auto source : {NoiseSource::Drive, NoiseSource::Range, NoiseSource::Proximity,
                              NoiseSource::Bumper, NoiseSource::Lidar, NoiseSource::Compass}) {
      for (std::size_t index = 0; index < 4; ++index) {
        EXPECT_NE(snow, noise_stream(1, 0, source, index).bits());
      }
    }
  }
}

}  // namespace
}  // namespace eyebridge::robot
