#include "eyebridge/localisation/scan_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "tour.hpp"

namespace eyebridge::localisation {
namespace {

using namespace testing;

/// `pose`, put up to 20 cm to any side and turned by up to 15 degrees.
Pose put_off(const Pose& pose, Random& random) {
  const double angle = 2 * kPi * random.uniform();
  const double away = 0.2 * random.uniform();
  return {pose.x + away * std::cos(angle), pose.y + away * std::sin(angle),
          wrap_angle(pose.theta + deg_to_rad(15) * (2 * random.uniform() - 1))};
}

struct Errors {
  double distance = 0.0;  ///< The largest, metres.
  double turn = 0.0;      ///< The largest, radians.
  double nees = 0.0;      ///< The mean.
  int count = 0;
};

void add_error(Errors& errors, const PoseEstimate& estimate, const Pose& truth) {
  errors.distance = std::max(errors.distance, distance(estimate.pose, truth));
  errors.turn = std::max(errors.turn, turn_between(estimate.pose, truth));
  const double nees = normalised_error_squared(estimate, truth).value();
  errors.nees += (nees - errors.nees) / ++errors.count;
}

TEST(ScanMatcher, FindsNoisyScansInAMapToACentimetreAndHalfADegree) {
  const ScanMatcher matcher(walls_in(flat(), 0.05), {});
  Random random(21);
  Errors errors;
  for (const Stop& stop : tour_of(scanner("realistic"), 1)) {
    const auto match = matcher.match(put_off(stop.truth, random), stop.scan);
    ASSERT_TRUE(match);
    add_error(errors, match->estimate, stop.truth);
  }
  RecordProperty("worst_m", std::to_string(errors.distance));
  RecordProperty("worst_degrees", std::to_string(rad_to_deg(errors.turn)));
  EXPECT_LE(errors.distance, 0.01);
  EXPECT_LE(errors.turn, deg_to_rad(0.5));
  // 3 where the covariance is right.
  EXPECT_GT(errors.nees, 1.0);
  EXPECT_LT(errors.nees, 6.0);
}

TEST(ScanMatcher, FindsTheWayFromOneNoisyScanToTheNext) {
  const std::vector<Stop> stops = tour_of(scanner("realistic"), 3);
  Random random(22);
  Errors errors;
  for (std::size_t i = 1; i < stops.size(); i += 4) {
    const ScanMatcher matcher(walls_seen(stops[i - 1].scan, 0.04, 0.3, 0.5), {});
    const Pose truth = relative_to(stops[i - 1].truth, stops[i].truth);
    const auto match = matcher.match(put_off(truth, random), stops[i].scan);
    ASSERT_TRUE(match) << "stop " << i;
    add_error(errors, match->estimate, truth);
  }
  EXPECT_LE(errors.distance, 0.02) << errors.nees;
  EXPECT_LE(errors.turn, deg_to_rad(1)) << errors.nees;
}

TEST(ScanMatcher, SearchesInBlocksWhatItWouldFindOneByOne) {
  const auto walls = walls_in(flat(), 0.05);
  MatchSettings one_by_one;
  one_by_one.block = 1;
  MatchSettings in_fives;
  in_fives.block = 5;
  const ScanMatcher slow(walls, one_by_one);
  const ScanMatcher fast(walls, {});
  const ScanMatcher other(walls, in_fives);
  Random random(23);
  const std::vector<Stop> stops = tour_of(scanner("harsh"), 4);
  for (std::size_t i = 0; i < stops.size(); i += 10) {
    const Pose guess = put_off(stops[i].truth, random);
    const Scan scan = stops[i].scan.thinned(60);
    const Pose expected = slow.search(guess, scan);
    EXPECT_EQ(fast.search(guess, scan), expected);
    EXPECT_EQ(other.search(guess, scan), expected);
    EXPECT_LE(std::abs(expected.x - guess.x), 0.25 + 1e-9);
    EXPECT_LE(turn_between(expected, guess), deg_to_rad(20) + 1e-9);
  }
}

TEST(ScanMatcher, KnowsThatACorridorSaysNothingAboutTheWayAlongIt) {
  // Two long walls along x; the scan sees 1 m of both.
  mapping::Raster<std::uint8_t> walls({{0, 0}, 0.05, 200, 40});
  for (int column = 0; column < 200; ++column) {
    walls[{column, 10}] = 1;
    walls[{column, 30}] = 1;
  }
  Scan scan;
  for (int i = 0; i < 40; ++i) {
    scan.hits.push_back({0.025 * i - 0.5, 0.5});
    scan.hits.push_back({0.025 * i - 0.5, -0.5});
  }
  const auto match = ScanMatcher(walls, {}).match({5.0, 1.12, 0.1}, scan);
  ASSERT_TRUE(match);
  // Between the centres of rows 10 and 30.
  EXPECT_NEAR(match->estimate.pose.y, 1.025, 1e-3);
  EXPECT_NEAR(match->estimate.pose.theta, 0.0, 1e-3);
  const Matrix3& covariance = match->estimate.covariance;
  EXPECT_GT(std::sqrt(covariance(0, 0)), 0.2);
  EXPECT_LT(std::sqrt(covariance(1, 1)), 0.01);
  EXPECT_LT(std::sqrt(covariance(2, 2)), 0.01);
}

TEST(ScanMatcher, IsNotLedAstrayByAFifthOfHitsThatAreNoWalls) {
  const ScanMatcher matcher(walls_in(flat(), 0.05), {});
  Random random(24);
  const std::vector<Stop> stops = tour_of(scanner("realistic"), 5);
  Errors errors;
  for (std::size_t i = 0; i < stops.size(); i += 4) {
    Scan scan = stops[i].scan;
    for (Vec2& hit : scan.hits) {
      if (random.chance(0.2)) hit = random.uniform() * hit;  // somebody walks by
    }
    const auto match = matcher.match(put_off(stops[i].truth, random), scan);
    ASSERT_TRUE(match);
    add_error(errors, match->estimate, stops[i].truth);
  }
  EXPECT_LE(errors.distance, 0.02);
  EXPECT_LE(errors.turn, deg_to_rad(1));
}

TEST(ScanMatcher, MatchesNothingWhereNothingFits) {
  const std::vector<Stop> stops = tour_of(scanner("perfect"), 1);
  const auto walls = walls_in(flat(), 0.05);
  const ScanMatcher matcher(walls, {});
  EXPECT_FALSE(matcher.match(stops[0].truth, {}));
  // Out of the window: at the other end of the flat, and beyond its walls.
  EXPECT_FALSE(matcher.match({3.3, 2.4, 1}, stops[0].scan));
  EXPECT_FALSE(matcher.match({50, -50, 1}, stops[0].scan));
  const ScanMatcher empty(mapping::Raster<std::uint8_t>(walls.geometry), {});
  EXPECT_FALSE(empty.match(stops[0].truth, stops[0].scan));
  EXPECT_TRUE(matcher.match(stops[0].truth, stops[0].scan));
}

TEST(ScanMatcher, KnowsDistancesFromTheMiddleOfTheOutermostCellsOn) {
  const mapping::Raster<std::uint8_t> walls({{0, 0}, 0.5, 4, 4}, 1);
  MatchSettings still;
  still.rounds = 0;
  const ScanMatcher matcher(walls, still);
  const auto score_of = [&](Vec2 hit) {
    Scan scan;
    scan.hits = {hit};
    return matcher.refined({}, scan).score;
  };
  EXPECT_EQ(score_of({1, 1}), 1.0);
  EXPECT_EQ(score_of({0.25, 1}), 1.0);
  EXPECT_EQ(score_of({1, 0.25}), 1.0);
  EXPECT_EQ(score_of({0.25, 0.25}), 1.0);
  for (const Vec2 rim : {Vec2{0.24, 1}, Vec2{1, 0.24}, Vec2{1.75, 1}, Vec2{1, 1.75}}) {
    EXPECT_EQ(score_of(rim), 0.0) << rim.x << ", " << rim.y;
  }
}

TEST(ScanMatcher, RefusesSettingsThatCannotBe) {
  const auto walls = walls_in(flat(), 0.05);
  const auto with = [&](auto&& change) {
    MatchSettings settings;
    change(settings);
    return ScanMatcher(walls, settings);
  };
  EXPECT_THROW(with([](MatchSettings& s) { s.window = 0; }), std::invalid_argument);
  EXPECT_THROW(with([](MatchSettings& s) { s.window = INFINITY; }), std::invalid_argument);
  EXPECT_THROW(with([](MatchSettings& s) { s.turn_window = 4; }), std::invalid_argument);
  EXPECT_THROW(with([](MatchSettings& s) { s.sigma = NAN; }), std::invalid_argument);
  EXPECT_THROW(with([](MatchSettings& s) { s.block = 0; }), std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::localisation
