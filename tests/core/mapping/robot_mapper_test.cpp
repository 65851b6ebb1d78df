#include "eyebridge/mapping/robot_mapper.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "bad_numbers.hpp"
#include "eyebridge/mapping/beam_model.hpp"
#include "eyebridge/mapping/scan_mapper.hpp"

namespace eyebridge::mapping {
namespace {

OccupancyGrid floor_grid() { return OccupancyGrid({{-3.0, -3.0}, 0.1, 60, 60}); }

constexpr Pose kStand{0.05, 0.05, 0.0};

/// A robot with three rays, to the left, ahead and to the right, and a LIDAR.
robot::RobotModel some_robot() {
  robot::RobotModel robot;
  for (const double bearing : {kPi / 2, 0.0, -kPi / 2}) {
    robot::RangeSensorModel& sensor = robot.range_sensors.emplace_back();
    sensor.pose_in_robot = {0.1, 0.0, bearing};
    sensor.max_range = 2.5;
  }
  robot.lidar.emplace().max_range = 2.5;
  return robot;
}

TEST(RobotMapper, TakesAnEchoForAnArcAndARayForALine) {
  robot::RobotModel robot;
  robot.range_sensors.emplace_back().max_range = 3.0;
  robot.range_sensors.emplace_back(robot.range_sensors[0]).kind = robot::RangeKind::Ultrasound;
  RobotMapper mapper(robot);
  OccupancyGrid by_ray({{-2.0, -2.0}, 0.1, 50, 40});
  OccupancyGrid by_cone(by_ray.geometry());
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(mapper.insert_range(by_ray, {0.0, 0.05, 0.0}, 0, 1.5));
    ASSERT_TRUE(mapper.insert_range(by_cone, {0.0, 0.05, 0.0}, 1, 1.5));
  }
  const Vec2 beside{0.95, 0.15};  // six degrees off the axis
  EXPECT_EQ(by_ray.probability(beside), 0.5);
  EXPECT_LT(by_cone.probability(beside), 0.4);
  EXPECT_LT(by_cone.probability(Vec2{0.95, 0.05}), by_cone.probability(beside)) << "on the axis";
}

TEST(RobotMapper, LearnsNothingFromWhatLooksDown) {
  robot::RobotModel robot;
  robot.range_sensors.emplace_back().kind = robot::RangeKind::Down;
  RobotMapper mapper(robot);
  OccupancyGrid grid({{-2.0, -2.0}, 0.1, 50, 40});
  ASSERT_TRUE(mapper.insert_range(grid, {0.0, 0.05, 0.0}, 0, 1.5));
  EXPECT_EQ(grid.probability(Vec2{0.95, 0.05}), 0.5);
}

TEST(RobotMapper, TakesAReadingFromWhereItsSensorLooks) {
  RobotMapper mapper(some_robot());
  OccupancyGrid grid = floor_grid();
  // Turned to the left: its left sensor looks back along x.
  ASSERT_TRUE(mapper.insert_range(grid, {0.05, 0.05, kPi / 2}, 0, 1.0));
  EXPECT_GT(grid.probability(Vec2{-0.95, 0.15}), 0.7);
  EXPECT_LT(grid.probability(Vec2{-0.55, 0.15}), 0.5);
  EXPECT_EQ(grid.probability(Vec2{0.55, 0.15}), 0.5);
}

TEST(RobotMapper, TakesAllReadingsAsItTakesThemOneByOne) {
  RobotMapper mapper(some_robot());
  OccupancyGrid together = floor_grid();
  OccupancyGrid one_by_one = floor_grid();
  const std::vector<double> ranges{1.0, 1.5, 2.0};
  ASSERT_TRUE(mapper.insert_ranges(together, kStand, ranges));
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(mapper.insert_range(one_by_one, kStand, i, ranges[i]));
  }
  EXPECT_EQ(together.raster(), one_by_one.raster());
  for (const Vec2 met : {Vec2{0.15, 1.05}, Vec2{1.65, 0.05}, Vec2{0.15, -1.95}}) {
    EXPECT_GT(together.probability(met), 0.7) << met.x << ", " << met.y;
  }
}

TEST(RobotMapper, WantsAReadingOfEachSensorThatIsThere) {
  RobotMapper mapper(some_robot());
  OccupancyGrid grid = floor_grid();
  for (const std::size_t count : {0U, 2U, 4U}) {
    const std::vector<double> ranges(count, 1.0);
    EXPECT_THROW((void)mapper.insert_ranges(grid, kStand, ranges), std::out_of_range) << count;
  }
  EXPECT_THROW((void)mapper.insert_range(grid, kStand, 3, 1.0), std::out_of_range);
  RobotMapper blind{robot::RobotModel{}};
  EXPECT_TRUE(blind.insert_ranges(grid, kStand, {}));
  const std::vector<double> scan(4, 1.0);
  EXPECT_THROW((void)blind.insert_lidar(grid, kStand, 2 * kPi, scan), std::out_of_range);
  EXPECT_EQ(grid.revision(), 0U);
}

TEST(RobotMapper, FailsWithTheFirstReadingThatCannotBeTaken) {
  RobotMapper mapper(some_robot());
  OccupancyGrid grid = floor_grid();
  const std::vector<double> ranges(3, 1.0);
  const auto result = mapper.insert_ranges(grid, {kNotANumber, 0.0, 0.0}, ranges);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, Errc::OutOfRange);
  EXPECT_EQ(grid.revision(), 0U);
}

/// Where rays of a scan ended, in order, when each is as long as its number.
void expect_ends(RobotMapper& mapper, double field_of_view, const std::vector<double>& ranges,
                 const std::vector<double>& bearings) {
  OccupancyGrid grid = floor_grid();
  ASSERT_TRUE(mapper.insert_lidar(grid, kStand, field_of_view, ranges));
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Vec2 end =
        kStand.position() + ranges[i] * Vec2{std::cos(bearings[i]), std::sin(bearings[i])};
    EXPECT_GT(grid.probability(end), 0.7) << "ray " << i << " of " << ranges.size();
  }
}

TEST(RobotMapper, TakesRaysOfALidarClockwiseFromWhereItsViewBegins) {
  RobotMapper mapper(some_robot());
  const std::vector<double> four{1.0, 1.3, 1.6, 1.9};
  expect_ends(mapper, 2 * kPi, four, {kPi, kPi / 2, 0.0, -kPi / 2});
  expect_ends(mapper, kPi, {1.0, 1.3, 1.6}, {kPi / 2, 0.0, -kPi / 2});
  expect_ends(mapper, kPi / 2, {1.0, 1.3, 1.6}, {kPi / 4, 0.0, -kPi / 4});
  expect_ends(mapper, kPi, {1.2}, {0.0});
  expect_ends(mapper, 2 * kPi, {1.2}, {kPi});
  expect_ends(mapper, 2 * kPi, four, {kPi, kPi / 2, 0.0, -kPi / 2});
}

TEST(RobotMapper, TakesAScanFromWhereTheLidarIs) {
  robot::RobotModel robot = some_robot();
  robot.lidar->pose_in_robot = {0.2, 0.1, kPi / 2};
  RobotMapper mapper(robot);
  OccupancyGrid grid = floor_grid();
  const double range = 1.5;
  ASSERT_TRUE(mapper.insert_lidar(grid, {0.05, 0.05, kPi / 2}, kPi, {&range, 1}));
  EXPECT_GT(grid.probability(Vec2{-0.05 - 1.5, 0.25}), 0.7);
}

TEST(RobotMapper, TakesAScanOfATiltedLidarForWhatItIsOverTheFloor) {
  robot::RobotModel robot = some_robot();
  robot.lidar->tilt = deg_to_rad(3);
  robot.lidar->height = 1.0;
  robot.lidar->max_range = 5.0;
  RobotMapper mapper(robot);
  const std::vector<double> ranges{1.7, 1.8, 1.9, 2.0, 2.1};
  OccupancyGrid grid({{-3.0, -3.0}, 0.001, 6000, 6000});
  ASSERT_TRUE(mapper.insert_lidar(grid, {0.0005, 0.0005, 0.0}, 2 * kPi / 3, ranges));
  const double level = 1.9 * std::cos(deg_to_rad(3));
  EXPECT_GT(grid.probability(Vec2{0.0005 + level, 0.0005}), 0.7);
  EXPECT_LT(grid.probability(Vec2{0.0005 + level - 0.002, 0.0005}), 0.5);
}

/// 400 rays over `field_of_view`, one after the other as long as if they met the edges of a room
/// with a pillar.
struct LongScan {
  explicit LongScan(double field_of_view) : gap(field_of_view / 400) {
    for (int i = 0; i < 400; ++i) {
      directions.push_back(Heading::from_angle(field_of_view / 2 - i * gap).forward());
      const Vec2 d = directions.back();
      const double edge = 1.5 / std::max(std::abs(d.x), std::abs(d.y));
      ranges.push_back(i % 100 < 30 ? 0.8 : edge);
    }
  }
  double gap;
  std::vector<Vec2> directions;
  std::vector<double> ranges;
};

TEST(RobotMapper, TakesAWholeTurnAsASweepAndMoreThanThatAsSingleRays) {
  RobotMapper mapper(some_robot());
  ScanMapper scan_mapper(beam_model_of(*some_robot().lidar));
  const Vec2 place = kStand.position();
  const LongScan turn(2 * kPi);
  OccupancyGrid grid = floor_grid();
  OccupancyGrid expected = floor_grid();
  ASSERT_TRUE(mapper.insert_lidar(grid, kStand, 2 * kPi, turn.ranges));
  ASSERT_TRUE(scan_mapper.insert_sweep(expected, place, turn.directions, turn.gap, turn.ranges));
  EXPECT_EQ(grid.raster(), expected.raster());
  const LongScan more(3 * kPi);
  grid.clear();
  expected.clear();
  ASSERT_TRUE(mapper.insert_lidar(grid, kStand, 3 * kPi, more.ranges));
  ASSERT_TRUE(scan_mapper.insert(expected, place, more.directions, more.ranges));
  EXPECT_EQ(grid.raster(), expected.raster());
}

}  // namespace
}  // namespace eyebridge::mapping
