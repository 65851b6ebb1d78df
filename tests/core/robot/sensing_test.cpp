#include "sensing.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "errors.hpp"

namespace eyebridge::robot {
namespace {

TEST(Sector, HoldsTheBearingsBetweenItsEnds) {
  EXPECT_TRUE(in_sector(0.0, -0.5, 0.5));
  EXPECT_TRUE(in_sector(0.5, -0.5, 0.5));
  EXPECT_TRUE(in_sector(-0.5, -0.5, 0.5));
  EXPECT_FALSE(in_sector(0.51, -0.5, 0.5));
  EXPECT_FALSE(in_sector(kPi, -0.5, 0.5));
}

TEST(Sector, GoesCounterClockwiseThroughTheBack) {
  const double start = deg_to_rad(150);
  const double end = deg_to_rad(-150);
  EXPECT_TRUE(in_sector(kPi, start, end));
  EXPECT_TRUE(in_sector(-kPi + 1e-6, start, end));
  EXPECT_TRUE(in_sector(deg_to_rad(170), start, end));
  EXPECT_TRUE(in_sector(deg_to_rad(-170), start, end));
  EXPECT_FALSE(in_sector(0.0, start, end));
  EXPECT_TRUE(in_sector(0.0, end, start)) << "the other way round is the rest of the circle";
  EXPECT_FALSE(in_sector(kPi, end, start));
}

TEST(Sector, TakesDegreesFromZeroToThreeSixty) {
  EXPECT_TRUE(in_sector(deg_to_rad(-20), deg_to_rad(330), deg_to_rad(390)));
  EXPECT_TRUE(in_sector(3.0, 0.0, 2 * kPi)) << "a whole turn";
  EXPECT_FALSE(in_sector(0.1, 0.0, 0.0)) << "a single bearing";
}

TEST(Scan, FullCircleStartsBehindAndGoesClockwise) {
  const std::vector<Vec2> rays = ScanShape(2 * kPi, 360).directions;
  ASSERT_EQ(rays.size(), 360u);
  EXPECT_NEAR(rays[0].x, -1.0, 1e-12);
  EXPECT_NEAR(rays[90].y, 1.0, 1e-12) << "left";
  EXPECT_NEAR(rays[180].x, 1.0, 1e-12) << "front";
  EXPECT_NEAR(rays[270].y, -1.0, 1e-12) << "right";
}

TEST(Scan, PartOfACircleGoesFromLeftMostToRightMost) {
  const std::vector<Vec2> rays = ScanShape(kPi, 181).directions;
  EXPECT_NEAR(rays[0].y, 1.0, 1e-12);
  EXPECT_NEAR(rays[90].x, 1.0, 1e-12);
  EXPECT_NEAR(rays[180].y, -1.0, 1e-12);
}

TEST(Scan, ASingleRayLooksAhead) { EXPECT_EQ(ScanShape(1.0, 1).directions[0], (Vec2{1.0, 0.0})); }

TEST(Scan, ShapesAreToldApartAndKept) {
  ScanShapes shapes;
  EXPECT_EQ(shapes.of(kPi, 3).directions.size(), 3U);
  EXPECT_NEAR(shapes.of(kPi / 2, 3).directions[0].x, std::sqrt(0.5), 1e-12);
  EXPECT_EQ(shapes.of(kPi / 2, 5).directions.size(), 5U);
  const Vec2* const kept = shapes.of(kPi, 3).directions.data();
  shapes.of(kPi / 2, 5);
  EXPECT_EQ(shapes.of(kPi, 3).directions.data(), kept);
  // More than are kept: the one that was not asked for longest is made anew, and the same.
  for (std::size_t points = 10; points < 30; ++points) {
    EXPECT_EQ(shapes.of(1.0, points).directions.size(), points);
  }
  EXPECT_NEAR(shapes.of(kPi, 3).directions[0].y, 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(shapes.of(kPi, 3).gap, -kPi / 2);
}

TEST(Sight, FollowsTheRobot) {
  const Sight sight = Sight(Pose{0.1, 0.02, kPi / 2}).in_world({1.0, 2.0}, Heading{0.0, 1.0});
  EXPECT_NEAR(sight.origin.x, 0.98, 1e-15);
  EXPECT_NEAR(sight.origin.y, 2.1, 1e-15);
  EXPECT_NEAR(sight.heading.cos, -1.0, 1e-15);
}

TEST(RangeReading, OutsideItsReachIsOutOfRange) {
  RangeSensorModel model;
  model.min_range = 0.05;
  model.max_range = 0.8;
  model.out_of_range = 9.999;
  Random random(1);
  EXPECT_EQ(range_reading(0.049, model, random), 9.999);
  EXPECT_EQ(range_reading(0.05, model, random), 0.05);
  EXPECT_EQ(range_reading(0.79, model, random), 0.79);
  EXPECT_EQ(range_reading(0.8, model, random), 9.999);
}

TEST(RangeReading, NoiseNeverLeavesTheScale) {
  RangeSensorModel model;
  model.max_range = 0.8;
  model.error.sigma = 0.5;
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double reading = range_reading(0.4, model, random);
    ASSERT_GE(reading, 0.0);
    ASSERT_LE(reading, 0.8);
  }
}

TEST(GaussianError, HasTheMeanAndSpreadItWasGiven) {
  const GaussianError error{0.02, 0.01, 0.05};
  Random random(7);
  constexpr int kCount = 100000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double off = with_error(2.0, error, random) - 2.0;
    sum += off;
    squares += off * off;
  }
  const double mean = sum / kCount;
  const double sigma = std::sqrt(squares / kCount - mean * mean);
  EXPECT_NEAR(mean, 0.02, 0.002);
  EXPECT_NEAR(sigma, 0.01 + 0.05 * 2.0, 0.001);
}

TEST(GaussianError, WithoutSpreadDrawsNothing) {
  Random used(3);
  Random untouched(3);
  EXPECT_EQ(with_error(1.0, {}, used), 1.0);
  EXPECT_EQ(with_error(1.0, {0.25, 0.0, 0.0}, used), 1.25);
  EXPECT_EQ(used.bits(), untouched.bits());
}

TEST(NoiseStream, NoTwoDevicesShareOne) {
  const auto first = [](std::uint32_t robot, NoiseSource source, std::size_t index) {
    return noise_stream(1, robot, source, index).bits();
  };
  const std::uint64_t base = first(0, NoiseSource::Range, 0);
  EXPECT_EQ(base, first(0, NoiseSource::Range, 0));
  EXPECT_NE(base, first(0, NoiseSource::Range, 1));
  EXPECT_NE(base, first(1, NoiseSource::Range, 0));
  EXPECT_NE(base, first(0, NoiseSource::Lidar, 0));
  EXPECT_NE(base, first(0, NoiseSource::Camera, 0));
  EXPECT_NE(base, noise_stream(2, 0, NoiseSource::Range, 0).bits());
}

TEST(SlantedBeam, ReadsAlongTheBeam) {
  LidarModel model;
  model.height = 0.1;
  model.max_range = 5.0;
  const SlantedBeam level(model, 0.0);
  EXPECT_EQ(level.level_reach(), 5.0);
  EXPECT_EQ(level.range(1.5), 1.5);
  EXPECT_EQ(level.range(5.0), 5.0);

  const SlantedBeam down(model, deg_to_rad(30));
  EXPECT_NEAR(down.level_reach(), 0.1 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(down.range(0.1), 0.1 / std::cos(kPi / 6), 1e-12);
  EXPECT_NEAR(down.range(down.level_reach()), 0.2, 1e-12) << "the floor";

  const SlantedBeam straight_down(model, kPi / 2);
  EXPECT_GE(straight_down.level_reach(), 0.0);
  EXPECT_EQ(straight_down.range(straight_down.level_reach()), 0.1);

  const SlantedBeam up(model, deg_to_rad(-60));
  EXPECT_NEAR(up.level_reach(), 2.5, 1e-12);
  EXPECT_EQ(up.range(up.level_reach()), 5.0);
}

}  // namespace
}  // namespace eyebridge::robot
