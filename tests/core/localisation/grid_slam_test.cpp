#include "eyebridge/localisation/grid_slam.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "eyebridge/base/hash.hpp"
#include "eyebridge/mapping/ground_truth.hpp"
#include "tour.hpp"

namespace eyebridge::localisation {
namespace {

using namespace testing;

constexpr double kResolution = 0.05;

GridSlamSettings settings_for_the_flat(const char* preset) {
  GridSlamSettings settings;
  settings.beam = mapping::beam_model_of(*scanner(preset).lidar);
  settings.geometry = mapping::GridGeometry::covering({-0.5, -0.5}, 5.0, 4.0, kResolution);
  return settings;
}

/// Where odometry alone takes a robot that began at `start`.
Pose by_odometry(const Pose& start, const Stop& stop) { return transform(start, stop.odometry); }

/// A scan of a robot at `pose` into a map.
void draw(mapping::OccupancyGrid& map, mapping::ScanMapper& mapper, const Pose& pose,
          const Scan& scan) {
  const Heading heading = Heading::from_angle(pose.theta);
  std::vector<Vec2> directions;
  std::vector<double> ranges;
  for (const Vec2 hit : scan.hits) {
    ranges.push_back(norm(hit));
    directions.push_back(heading.rotate((1 / norm(hit)) * hit));
  }
  ASSERT_TRUE(mapper.insert(map, pose.position(), directions, ranges));
}

TEST(GridSlam, DrawsTheFlatAndKnowsItsPlaceFarBetterThanOdometry) {
  mapping::TruthSettings truth_settings;
  truth_settings.resolution = kResolution;
  const mapping::OccupancyGrid truth_map = mapping::truth_of(flat(), truth_settings);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const std::vector<Stop> stops = tour_of(scanner("realistic"), seed);
    const Pose start = stops[0].truth;
    GridSlam slam(settings_for_the_flat("realistic"), start);
    mapping::OccupancyGrid odometry_map(settings_for_the_flat("realistic").geometry);
    mapping::ScanMapper mapper(settings_for_the_flat("realistic").beam);
    double farthest = 0;
    for (const Stop& stop : stops) {
      ASSERT_TRUE(slam.add(stop.odometry, stop.scan));
      draw(odometry_map, mapper, by_odometry(start, stop), stop.scan);
      farthest = std::max(farthest, distance(slam.pose(), stop.truth));
    }
    const Pose& truth = stops.back().truth;
    const double error = distance(slam.pose(), truth);
    const double odometry_error = distance(by_odometry(start, stops.back()), truth);
    const double agreement = mapping::agreement(slam.map(), truth_map).share();
    const double odometry_agreement = mapping::agreement(odometry_map, truth_map).share();
    SCOPED_TRACE(::testing::Message()
                 << "seed " << seed << ": " << error << " m, by odometry " << odometry_error
                 << " m; agreement " << agreement << ", " << odometry_agreement);
    const std::string run = "seed_" + std::to_string(seed);
    RecordProperty(run + "_error_m", std::to_string(error));
    RecordProperty(run + "_error_by_odometry_m", std::to_string(odometry_error));
    RecordProperty(run + "_agreement", std::to_string(agreement));
    EXPECT_EQ(slam.unmatched(), 0U);
    // Walls lie between cells here: the map may be off by half a cell along x and y.
    EXPECT_LE(error, kResolution);
    EXPECT_LE(farthest, 2 * kResolution);
    EXPECT_LE(turn_between(slam.pose(), truth), deg_to_rad(1.5));
    EXPECT_GE(odometry_error, 20 * error);
    EXPECT_GE(agreement, 0.98);
    EXPECT_LE(1 - agreement, 0.15 * (1 - odometry_agreement));
  }
}

TEST(GridSlam, GivesTheSameBitsForTheSameCalls) {
  const std::vector<Stop> stops = tour_of(scanner("realistic"), 5);
  const auto run = [&] {
    GridSlam slam(settings_for_the_flat("realistic"), stops[0].truth);
    for (std::size_t i = 0; i < 15; ++i) EXPECT_TRUE(slam.add(stops[i].odometry, stops[i].scan));
    StateHash hash;
    hash.add(slam.pose().x);
    hash.add(slam.pose().theta);
    for (const float value : slam.map().raster().cells) hash.add(static_cast<double>(value));
    return hash.value();
  };
  EXPECT_EQ(run(), run());
}

TEST(GridSlam, SkipsScansOfARobotThatStandsStill) {
  const Stop stop = tour_of(scanner("perfect"), 1).front();
  GridSlam slam(settings_for_the_flat("perfect"), stop.truth);
  EXPECT_EQ(slam.add({1, 1, 0}, stop.scan), GridSlam::Outcome::Added);
  EXPECT_FALSE(slam.last_match());
  const auto before = slam.map().raster();
  EXPECT_EQ(slam.add({1.01, 1, 0}, stop.scan), GridSlam::Outcome::Skipped);
  EXPECT_EQ(slam.map().raster(), before);
  // It looks ahead, to the north.
  EXPECT_NEAR(slam.pose().y, stop.truth.y + 0.01, 1e-9);
}

TEST(GridSlam, LeavesOutAScanThatFitsNowhereAndGoesOnByOdometry) {
  const std::vector<Stop> stops = tour_of(scanner("perfect"), 1);
  GridSlam slam(settings_for_the_flat("perfect"), stops[0].truth);
  ASSERT_TRUE(slam.add(stops[0].odometry, stops[0].scan));
  const auto before = slam.map().raster();
  Scan nonsense;
  for (int i = 0; i < 50; ++i) nonsense.hits.push_back({0.1, 0.002 * i - 0.05});
  EXPECT_EQ(slam.add(stops[2].odometry, nonsense), GridSlam::Outcome::Unmatched);
  EXPECT_EQ(slam.add(stops[3].odometry, {}), GridSlam::Outcome::Unmatched);
  EXPECT_EQ(slam.unmatched(), 2U);
  EXPECT_EQ(slam.map().raster(), before);
  EXPECT_LT(distance(slam.pose(), by_odometry(stops[0].truth, stops[3])), 1e-9);
  EXPECT_EQ(slam.add(stops[4].odometry, stops[4].scan), GridSlam::Outcome::Added);
  EXPECT_TRUE(slam.last_match());
  EXPECT_LT(distance(slam.pose(), stops[4].truth), kResolution);
}

TEST(GridSlam, GrowsWithWhatTheRobotSees) {
  const std::vector<Stop> stops = tour_of(scanner("perfect"), 1);
  GridSlamSettings settings = settings_for_the_flat("perfect");
  settings.geometry = mapping::GridGeometry::covering({0, 0}, 1.0, 1.0, kResolution);
  settings.occupancy.growing = true;
  GridSlam slam(settings, stops[0].truth);
  for (std::size_t i = 0; i < 20; ++i) ASSERT_TRUE(slam.add(stops[i].odometry, stops[i].scan));
  EXPECT_GT(slam.map().geometry().size(), settings.geometry.size());
  EXPECT_LT(distance(slam.pose(), stops[19].truth), kResolution);
  settings.occupancy.max_cells = 600;
  GridSlam small(settings, stops[0].truth);
  EXPECT_FALSE(small.add(stops[0].odometry, stops[0].scan));
}

TEST(GridSlam, RefusesOdometryThatIsNoPlaceAndGoesOn) {
  GridSlam slam(settings_for_the_flat("perfect"), {1, 1, 0});
  EXPECT_FALSE(slam.add({std::nan(""), 0, 0}, {}));
  EXPECT_EQ(slam.pose(), (Pose{1, 1, 0}));
  EXPECT_TRUE(slam.add({0, 0, 0}, {}));
}

TEST(GridSlam, RefusesSettingsThatCannotBe) {
  EXPECT_THROW(GridSlam({}, {}), std::invalid_argument);
  GridSlamSettings settings = settings_for_the_flat("perfect");
  settings.update_turn = -1;
  EXPECT_THROW(GridSlam(settings, {}), std::invalid_argument);
  settings = settings_for_the_flat("perfect");
  settings.beam.crossed = 0.6;
  EXPECT_THROW(GridSlam(settings, {}), std::invalid_argument);
  settings = settings_for_the_flat("perfect");
  settings.match.sigma = 0;
  EXPECT_THROW(GridSlam(settings, {}), std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::localisation
