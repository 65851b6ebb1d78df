// The error models as values: presets, scales, tables; how a robot gets them and which streams of
// random numbers they touch.
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/robot/error_presets.hpp"
#include "rig.hpp"

namespace eyebridge::robot {
namespace {

/// A robot with every kind of device, the PSDs with a table.
RobotModel full_model() {
  RobotModel model;
  model.range_sensors.resize(2);
  model.range_sensors[1].id = 2;
  for (RangeSensorModel& sensor : model.range_sensors) sensor.table = RangeTable({1.8, 1.9, 2.0});
  model.proximity_sensors.resize(1);
  model.proximity_sensors[0].threshold = 1.5;
  model.bumpers = {{1, "ring", 0.0, 2 * kPi, {}}};
  model.lidar = LidarModel{};
  model.range_matrices.emplace_back();
  model.camera = CameraModel{};
  return model;
}

RobotModel with_preset(const char* name) {
  RobotModel model = full_model();
  set_errors(model, error_preset(name).value());
  return model;
}

TEST(ErrorPresets, HaveTheNamesThatAreTold) {
  for (const std::string_view name : kErrorPresets) EXPECT_TRUE(error_preset(name)) << name;
  EXPECT_FALSE(error_preset("Perfect"));
  EXPECT_FALSE(error_preset(""));
}

TEST(ErrorPresets, PerfectIsNoErrorAndTheOthersHaveOneOfEveryKind) {
  EXPECT_EQ(with_preset("perfect"), full_model());
  EXPECT_TRUE(is_perfect(full_model()));
  for (const char* name : {"realistic", "harsh"}) {
    int kinds = 0;
    const RobotModel model = with_preset(name);
    for_each_error(model, [&](const auto& error, int id) {
      EXPECT_FALSE(error.perfect()) << name << ", device " << id;
      ++kinds;
    });
    EXPECT_EQ(kinds, 12);
  }
}

TEST(ErrorPresets, HarshIsNowhereMilderThanRealistic) {
  const ErrorModels some = *error_preset("realistic");
  const ErrorModels many = *error_preset("harsh");
  EXPECT_GT(many.drive.linear_sigma, some.drive.linear_sigma);
  EXPECT_GT(many.drive.slip, some.drive.slip);
  EXPECT_GT(many.range.sigma, some.range.sigma);
  EXPECT_GT(many.range.dropout, some.range.dropout);
  EXPECT_GT(many.proximity.flip, some.proximity.flip);
  EXPECT_GT(many.bumper.miss, some.bumper.miss);
  EXPECT_GT(many.lidar.sigma_relative, some.lidar.sigma_relative);
  EXPECT_GT(many.compass.sigma, some.compass.sigma);
  EXPECT_GT(many.camera.sigma, some.camera.sigma);
  EXPECT_GT(many.radio.loss, some.radio.loss);
  EXPECT_LT(many.radio.range, some.radio.range);
}

TEST(ErrorScale, NothingIsPerfectAndAllOfItIsAsItWas) {
  for (const char* name : {"realistic", "harsh"}) {
    RobotModel model = with_preset(name);
    scale_errors(model, 1.0);
    EXPECT_EQ(model, with_preset(name));
    scale_errors(model, 0.0);
    EXPECT_TRUE(is_perfect(model));
    EXPECT_EQ(model, full_model());
  }
}

TEST(ErrorScale, HalfOfItHalvesEveryAmount) {
  RobotModel model = with_preset("harsh");
  const RobotModel whole = model;
  scale_errors(model, 0.5);
  EXPECT_EQ(model.drive_error, (DriveError{0.04, 0.04, 0.006, -0.006, true, 0.005, 0.0025}));
  EXPECT_EQ(model.range_sensors[1].error, (RangeError{{0, 0.006, 0.02}, 0.01, true, 0.025}));
  EXPECT_EQ(model.lidar->error.dropout, whole.lidar->error.dropout / 2);
  EXPECT_EQ(model.compass_error.bias, whole.compass_error.bias / 2);
  EXPECT_EQ(model.camera->error, (CameraError{0.0025, 6, 0.0025, 0.75, -0.25, 0.075}));
  EXPECT_EQ(model.radio_error.range, 2 * whole.radio_error.range)
      << "half the error reaches as far";
}

TEST(RangeTable, RoundsToTheNearestEntryOfATableInAnyOrder) {
  const RangeTable table({9.999, 0.8, 0.4, 0.2, 0.1, 0.1, 0.0});
  EXPECT_EQ(table.levels(), (std::vector<double>{0.1, 0.2, 0.4, 0.8}));
  EXPECT_EQ(table.nearest(0.02, 9.999), 0.1);
  EXPECT_EQ(table.nearest(0.29, 9.999), 0.2);
  EXPECT_EQ(table.nearest(0.31, 9.999), 0.4);
  EXPECT_EQ(table.nearest(0.4, 9.999), 0.4);
  EXPECT_EQ(table.nearest(0.99, 9.999), 0.8);
  EXPECT_EQ(table.nearest(1.01, 9.999), 9.999) << "beyond the table nothing is seen";
}

TEST(RangeTable, WithoutEntriesItChangesNothing) {
  EXPECT_TRUE(RangeTable({0.0, -1.0, 9.999}).empty());
  EXPECT_EQ(RangeTable().nearest(0.123, 9.999), 0.123);
  EXPECT_EQ(RangeTable({0.5}).nearest(0.3, 9.999), 0.5);
  EXPECT_EQ(RangeTable({0.5}), RangeTable({0.5, 0.5}));
  EXPECT_NE(RangeTable({0.5}), RangeTable());
}

TEST(SetErrors, HoldsFromThenOn) {
  Rig rig(full_model());
  const double exact = rig.sim.read_range(rig.robot, 0);
  EXPECT_EQ(exact, 2.0);
  RobotModel like = rig.sim.model(rig.robot);
  like.range_sensors[0].error.bias = 0.25;
  rig.sim.set_errors(rig.robot, like);
  EXPECT_EQ(rig.sim.read_range(rig.robot, 0), 2.25);
  EXPECT_EQ(rig.sim.read_range(rig.robot, 1), 2.0) << "the other sensor";
  rig.sim.set_errors(rig.robot, full_model());
  EXPECT_EQ(rig.sim.read_range(rig.robot, 0), 2.0);
}

TEST(SetErrors, OfTheDriveChangesARobotOnItsWay) {
  Rig exact(full_model());
  Rig erring(full_model());
  for (Rig* rig : {&exact, &erring}) {
    rig->sim.set_speed(rig->robot, {0.3, 0.0});
    rig->steps(100);
  }
  RobotModel like = full_model();
  like.drive_error.right_scale = 0.05;
  like.drive_error.encoder_quantised = true;
  like.drive_error.slip = 0.1;
  like.drive_error.encoder_miss = 0.1;
  erring.sim.set_errors(erring.robot, like);
  exact.steps(100);
  erring.steps(100);
  EXPECT_EQ(exact.sim.pose(exact.robot).theta, 0.0);
  EXPECT_GT(erring.sim.pose(erring.robot).theta, 0.02);
  // Ticks counted before the change are not odometry's business, those missed later are.
  const double way = exact.sim.odometry(exact.robot).x;
  EXPECT_LT(erring.sim.odometry(erring.robot).x, way - 0.01);
  EXPECT_GT(erring.sim.odometry(erring.robot).x, way - 0.06);
}

TEST(SetErrors, OfARobotWithOtherDevicesIsRefused) {
  Rig rig(full_model());
  EXPECT_THROW(rig.sim.set_errors(rig.robot, RobotModel{}), std::invalid_argument);
  EXPECT_THROW(rig.sim.set_errors(rig.robot + 1, full_model()), std::out_of_range);
}

/// What every device of a robot reads on a course, one vector a device.
std::vector<std::vector<double>> course_readings(const RobotModel& model) {
  Rig rig(model);
  std::vector<std::vector<double>> readings(6);
  std::vector<double> scan(8);
  for (int i = 0; i < 50; ++i) {
    readings[0].push_back(rig.sim.read_range(rig.robot, 0));
    readings[1].push_back(rig.sim.read_range(rig.robot, 1));
    readings[2].push_back(rig.sim.read_proximity(rig.robot, 0) ? 1 : 0);
    readings[3].push_back(rig.sim.read_compass(rig.robot));
    rig.sim.read_lidar(rig.robot, 2 * kPi, scan);
    readings[4].insert(readings[4].end(), scan.begin(), scan.end());
  }
  rig.sim.set_speed(rig.robot, {0.1, 0.5});
  rig.steps(200);
  readings[5] = {rig.sim.pose(rig.robot).x, rig.sim.pose(rig.robot).y,
                 rig.sim.odometry(rig.robot).x, rig.sim.odometry(rig.robot).y};
  return readings;
}

TEST(ErrorStreams, TheErrorsOfOneDeviceDoNotShiftThoseOfAnother) {
  const RobotModel harsh = with_preset("harsh");
  const auto all = course_readings(harsh);
  const auto exact = course_readings(full_model());
  // Each device with errors alone reads as it does when all others err as well.
  for (std::size_t device = 0; device < all.size(); ++device) {
    RobotModel alone = full_model();
    if (device < 2) alone.range_sensors[device].error = harsh.range_sensors[device].error;
    if (device == 2) alone.proximity_sensors = harsh.proximity_sensors;
    if (device == 3) alone.compass_error = harsh.compass_error;
    if (device == 4) alone.lidar = harsh.lidar;
    if (device == 5) alone.drive_error = harsh.drive_error;
    const auto readings = course_readings(alone);
    for (std::size_t other = 0; other < all.size(); ++other) {
      EXPECT_EQ(readings[other], other == device ? all[other] : exact[other])
          << "device " << other << " with errors of device " << device;
    }
    EXPECT_NE(all[device], exact[device]) << device;
  }
}

TEST(ErrorStreams, SlipDoesNotShiftTheOtherErrorsOfTheDrive) {
  // A wheel that always holds and one that never misses a tick draw, but not from the stream of the
  // Gaussian errors: with probabilities that never hit, the way is the same.
  const auto end = [](double probability) {
    RobotModel model;
    model.drive_error.linear_sigma = 0.1;
    model.drive_error.angular_sigma = 0.1;
    model.drive_error.encoder_quantised = true;
    model.drive_error.slip = probability;
    model.drive_error.encoder_miss = probability;
    Rig rig(model);
    rig.sim.set_speed(rig.robot, {0.1, 0.5});
    rig.steps(100);
    return rig.sim.pose(rig.robot);
  };
  EXPECT_EQ(end(0.0), end(1e-15));
}

}  // namespace
}  // namespace eyebridge::robot
