#include "eyebridge/localisation/scan.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace eyebridge::localisation {
namespace {

robot::LidarModel lidar_at(const Pose& pose) {
  robot::LidarModel lidar;
  lidar.pose_in_robot = pose;
  lidar.max_range = 5.0;
  return lidar;
}

TEST(Scan, StartsBehindAndTurnsClockwiseWhenItIsACircle) {
  const std::vector<double> ranges = {1.0, 2.0, 3.0, 4.0};
  const Scan scan = scan_of(ranges, 2 * kPi, lidar_at({0.1, 0, 0}));
  EXPECT_EQ(scan.origin, (Vec2{0.1, 0}));
  ASSERT_EQ(scan.hits.size(), 4U);
  const Vec2 expected[] = {{-0.9, 0}, {0.1, 2}, {3.1, 0}, {0.1, -4}};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(norm(scan.hits[i] - expected[i]), 0, 1e-12) << i;
}

TEST(Scan, EndsOnBothSidesWhenItIsPartOfACircle) {
  const std::vector<double> ranges = {1.0, 1.0, 1.0};
  const Scan scan = scan_of(ranges, kPi, lidar_at({0, 0, kPi / 2}));
  const Vec2 expected[] = {{-1, 0}, {0, 1}, {1, 0}};
  ASSERT_EQ(scan.hits.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(norm(scan.hits[i] - expected[i]), 0, 1e-12) << i;
  const double one[] = {2.0};
  EXPECT_NEAR(norm(scan_of(one, kPi, lidar_at({})).hits.at(0) - Vec2{2, 0}), 0, 1e-12);
}

TEST(Scan, KeepsRaysThatMetNothingApartAndLeavesOutWhatIsNoRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> ranges = {5.0, 0.0, nan, 7.0, 1.0, -1.0};
  const Scan scan = scan_of(ranges, 2 * kPi, lidar_at({}));
  EXPECT_EQ(scan.hits.size(), 1U);
  ASSERT_EQ(scan.misses.size(), 2U);
  EXPECT_NEAR(norm(scan.misses[0]), 5.0, 1e-12);
  EXPECT_NEAR(norm(scan.misses[1]), 5.0, 1e-12);
}

TEST(Scan, IsRefusedFromAScannerThatLooksAtTheFloor) {
  robot::LidarModel lidar;
  lidar.tilt = 0.1;
  EXPECT_THROW((void)scan_of({}, kPi, lidar), std::invalid_argument);
}

TEST(Scan, IsMadeOfDistanceSensorsToo) {
  std::vector<robot::RangeSensorModel> sensors(4);
  sensors[0].pose_in_robot = {0.05, 0, 0};
  sensors[1].pose_in_robot = {0, 0.04, kPi / 2};
  sensors[1].max_range = 2.0;
  sensors[2].out_of_range = 0.5;
  const std::vector<double> ranges = {1.0, 3.0, 0.5, -1.0};
  const Scan scan = scan_of(ranges, sensors);
  ASSERT_EQ(scan.hits.size(), 1U);
  ASSERT_EQ(scan.misses.size(), 2U);
  EXPECT_NEAR(norm(scan.hits[0] - Vec2{1.05, 0}), 0, 1e-12);
  EXPECT_NEAR(norm(scan.misses[0] - Vec2{0, 2.04}), 0, 1e-12);
  sensors.pop_back();
  EXPECT_THROW((void)scan_of(ranges, sensors), std::invalid_argument);
}

TEST(Scan, OfADistanceSensorMetNothingAtTheEndOfItsReach) {
  std::vector<robot::RangeSensorModel> sensors(2);
  sensors[0].max_range = sensors[1].max_range = 2.0;
  const std::vector<double> ranges = {2.0, 1.999};
  const Scan scan = scan_of(ranges, sensors);
  EXPECT_EQ(scan.misses, (std::vector<Vec2>{{2.0, 0}}));
  EXPECT_EQ(scan.hits, (std::vector<Vec2>{{1.999, 0}}));
}

TEST(Scan, ThinsOutEvenly) {
  Scan scan;
  for (int i = 0; i < 10; ++i) scan.hits.push_back({static_cast<double>(i), 0});
  const Scan thin = scan.thinned(5);
  EXPECT_EQ(thin.hits, (std::vector<Vec2>{{0, 0}, {2, 0}, {4, 0}, {6, 0}, {8, 0}}));
  EXPECT_EQ(scan.thinned(20).hits, scan.hits);
  EXPECT_TRUE(Scan{}.thinned(3).hits.empty());
}

TEST(WallsSeen, JoinsHitsThatAreNearEachOther) {
  Scan scan;
  scan.hits = {{1, 0}, {1, 0.3}, {2, 0.3}};
  const auto walls = walls_seen(scan, 0.1, 0.5, 0.2);
  const auto seen = [&](Vec2 place) { return walls[walls.geometry.cell_at(place)] != 0; };
  for (const Vec2 place : {Vec2{1, 0}, Vec2{1, 0.1}, Vec2{1, 0.2}, Vec2{1, 0.3}, Vec2{2, 0.3}}) {
    EXPECT_TRUE(seen(place)) << place.x << ", " << place.y;
  }
  EXPECT_FALSE(seen({1.5, 0.3}));
  EXPECT_FALSE(seen({1.5, 0.15}));
  EXPECT_FALSE(seen({0, 0}));
  EXPECT_TRUE(walls.geometry.contains(walls.geometry.cell_at({2.15, -0.15})));
  EXPECT_FALSE(walls_seen({}, 0.1, 0.5, 0.2).cells.empty());
}

}  // namespace
}  // namespace eyebridge::localisation
