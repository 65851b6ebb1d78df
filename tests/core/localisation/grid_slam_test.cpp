#include "eyebridge/localisation/grid_slam.hpp"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "eyebridge/base/hash.hpp"
#include "eyebridge/mapping/distance_field.hpp"
#include "log_odds_map.hpp"
#include "tour.hpp"

namespace eyebridge::localisation {
namespace {

using namespace testing;

constexpr double kResolution = 0.05;

GridSlamSettings settings_for_the_flat() {
  GridSlamSettings settings;
  settings.geometry = walls_in(flat(), kResolution).geometry;
  return settings;
}

/// Share of the cells with log-odds of at least 1 either way that agree with the walls: occupied
/// ones have one at most a cell away; free ones are none, unless one beside them is occupied.
double agreement_with_the_flat(const mapping::Raster<float>& log_odds) {
  const auto walls = walls_in(flat(), kResolution);
  mapping::Raster<std::uint8_t> believed(log_odds.geometry);
  for (std::size_t i = 0; i < believed.cells.size(); ++i) {
    believed.cells[i] = log_odds.cells[i] >= 1 ? 1 : 0;
  }
  const auto to_wall = mapping::distance_field(walls);
  const auto to_believed = mapping::distance_field(believed);
  const float beside = 1.5F * static_cast<float>(kResolution);
  int known = 0;
  int right = 0;
  for (std::size_t i = 0; i < believed.cells.size(); ++i) {
    if (log_odds.cells[i] >= 1) {
      ++known;
      right += to_wall.cells[i] < beside ? 1 : 0;
    } else if (log_odds.cells[i] <= -1) {
      ++known;
      right += walls.cells[i] == 0 || to_believed.cells[i] < beside ? 1 : 0;
    }
  }
  return known == 0 ? 0.0 : static_cast<double>(right) / known;
}

/// Where odometry alone takes a robot that began at `start`.
Pose by_odometry(const Pose& start, const Stop& stop) { return transform(start, stop.odometry); }

TEST(GridSlam, DrawsTheFlatAndKnowsItsPlaceFarBetterThanOdometry) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const std::vector<Stop> stops = tour_of(scanner("realistic"), seed);
    const Pose start = stops[0].truth;
    GridSlam slam(settings_for_the_flat(), start);
    LogOddsMap odometry_map(settings_for_the_flat().geometry, 0.85F, -0.4F, 5.0F);
    double farthest = 0;
    for (const Stop& stop : stops) {
      slam.add(stop.odometry, stop.scan);
      odometry_map.insert(by_odometry(start, stop), stop.scan);
      farthest = std::max(farthest, distance(slam.pose(), stop.truth));
    }
    const Pose& truth = stops.back().truth;
    const double error = distance(slam.pose(), truth);
    const double odometry_error = distance(by_odometry(start, stops.back()), truth);
    const double agreement = agreement_with_the_flat(slam.log_odds());
    const double odometry_agreement = agreement_with_the_flat(odometry_map.log_odds());
    SCOPED_TRACE(::testing::Message()
                 << "seed " << seed << ": " << error << " m, by odometry " << odometry_error
                 << " m; agreement " << agreement << ", " << odometry_agreement);
    EXPECT_EQ(slam.unmatched(), 0U);
    EXPECT_LE(error, 0.03);
    EXPECT_LE(farthest, 0.05);
    EXPECT_LE(turn_between(slam.pose(), truth), deg_to_rad(1.5));
    EXPECT_GE(odometry_error, 10 * error);
    EXPECT_GE(agreement, 0.97);
    EXPECT_LE(1 - agreement, 0.25 * (1 - odometry_agreement));
  }
}

TEST(GridSlam, GivesTheSameBitsForTheSameCalls) {
  const std::vector<Stop> stops = tour_of(scanner("realistic"), 5);
  const auto run = [&] {
    GridSlam slam(settings_for_the_flat(), stops[0].truth);
    for (std::size_t i = 0; i < 15; ++i) slam.add(stops[i].odometry, stops[i].scan);
    StateHash hash;
    hash.add(slam.pose().x);
    hash.add(slam.pose().theta);
    for (const float value : slam.log_odds().cells) hash.add(static_cast<double>(value));
    return hash.value();
  };
  EXPECT_EQ(run(), run());
}

TEST(GridSlam, SkipsScansOfARobotThatStandsStill) {
  const Stop stop = tour_of(scanner("perfect"), 1).front();
  GridSlam slam(settings_for_the_flat(), stop.truth);
  EXPECT_EQ(slam.add({1, 1, 0}, stop.scan), GridSlam::Outcome::Added);
  EXPECT_FALSE(slam.last_match());
  const auto before = slam.log_odds();
  EXPECT_EQ(slam.add({1.01, 1, 0}, stop.scan), GridSlam::Outcome::Skipped);
  EXPECT_EQ(slam.log_odds(), before);
  // It looks ahead, to the north.
  EXPECT_NEAR(slam.pose().y, stop.truth.y + 0.01, 1e-9);
}

TEST(GridSlam, LeavesOutAScanThatFitsNowhereAndGoesOnByOdometry) {
  const std::vector<Stop> stops = tour_of(scanner("perfect"), 1);
  GridSlam slam(settings_for_the_flat(), stops[0].truth);
  slam.add(stops[0].odometry, stops[0].scan);
  const auto before = slam.log_odds();
  Scan nonsense;
  for (int i = 0; i < 50; ++i) nonsense.hits.push_back({0.1, 0.002 * i - 0.05});
  EXPECT_EQ(slam.add(stops[2].odometry, nonsense), GridSlam::Outcome::Unmatched);
  EXPECT_EQ(slam.add(stops[3].odometry, {}), GridSlam::Outcome::Unmatched);
  EXPECT_EQ(slam.unmatched(), 2U);
  EXPECT_EQ(slam.log_odds(), before);
  EXPECT_LT(distance(slam.pose(), by_odometry(stops[0].truth, stops[3])), 1e-9);
  EXPECT_EQ(slam.add(stops[4].odometry, stops[4].scan), GridSlam::Outcome::Added);
  EXPECT_TRUE(slam.last_match());
  EXPECT_LT(distance(slam.pose(), stops[4].truth), 0.02);
}

TEST(GridSlam, RefusesSettingsThatCannotBe) {
  EXPECT_THROW(GridSlam({}, {}), std::invalid_argument);
  GridSlamSettings settings = settings_for_the_flat();
  settings.crossed = 0.1;
  EXPECT_THROW(GridSlam(settings, {}), std::invalid_argument);
  settings = settings_for_the_flat();
  settings.match.sigma = 0;
  EXPECT_THROW(GridSlam(settings, {}), std::invalid_argument);
}

TEST(LogOddsMap, CountsEachScanOnceForACell) {
  LogOddsMap map({{0, 0}, 1.0, 6, 3}, 0.8F, -0.5F, 2.0F);
  Scan scan;
  scan.hits = {{4.0, 0.0}, {4.1, 0.1}, {3.0, 0.0}};
  map.insert({0.5, 1.5, 0}, scan);
  const auto row = [&](int column) { return map.log_odds()[{column, 1}]; };
  EXPECT_EQ(row(0), -0.5F);
  EXPECT_EQ(row(2), -0.5F);
  EXPECT_EQ(row(3), 0.8F);  // one ray ended there, others went through
  EXPECT_EQ(row(4), 0.8F);
  EXPECT_EQ(row(5), 0.0F);
  EXPECT_EQ((map.log_odds()[{2, 0}]), 0.0F);
  for (int i = 0; i < 5; ++i) map.insert({0.5, 1.5, 0}, scan);
  EXPECT_EQ(row(0), -2.0F);
  EXPECT_EQ(row(4), 2.0F);
  EXPECT_EQ((map.occupied()[{4, 1}]), 1);
  EXPECT_EQ((map.occupied()[{5, 1}]), 0);
  // Out of the grid and steep.
  scan.hits = {{30.0, 20.0}, {-5.0, -9.0}, {0.0, 1.0}};
  map.insert({0.5, 1.5, 0}, scan);
  EXPECT_EQ((map.log_odds()[{0, 2}]), 0.8F);
}

}  // namespace
}  // namespace eyebridge::localisation
