#include "eyebridge/localisation/monte_carlo.hpp"

#include <memory>
#include <stdexcept>

#include <gtest/gtest.h>

#include "eyebridge/base/hash.hpp"
#include "lost_robot.hpp"

namespace eyebridge::localisation {
namespace {

using namespace testing;

TEST(MonteCarlo, SpreadsOverAllThatIsFree) {
  const MonteCarlo filter = lost_in_the_flat(scanner("realistic"), 1);
  const auto free = room_for(flat(), walls_in(flat(), kCell), scanner("realistic").radius());
  const Particles& all = filter.particles();
  ASSERT_EQ(all.size(), filter.settings().most_particles);
  std::size_t west = 0;
  std::size_t north = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_NE(free[free.geometry.cell_at(all.pose(i).position())], 0);
    west += all.x[i] < 2 ? 1 : 0;
    north += all.theta[i] > 0 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(north) / static_cast<double>(all.size()), 0.5, 0.02);
  EXPECT_NEAR(static_cast<double>(west) / static_cast<double>(all.size()), 0.5, 0.06);
  EXPECT_NEAR(filter.effective_particles(), static_cast<double>(all.size()), 1e-6 * 8000);
}

TEST(MonteCarlo, FindsOutWhereItIsAndThenNeedsFewParticles) {
  const robot::RobotModel model = scanner("realistic");
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const std::vector<Stop> stops = tour_of(model, seed);
    MonteCarlo filter = lost_in_the_flat(model, seed);
    follow(filter, stops);
    found += knows(filter, stops.back().truth) ? 1 : 0;
    EXPECT_LT(filter.particles().size(), filter.settings().most_particles / 4);
  }
  EXPECT_EQ(found, 2);
}

TEST(MonteCarlo, GivesTheSameBitsForTheSameSeed) {
  const robot::RobotModel model = scanner("realistic");
  std::vector<Stop> stops = tour_of(model, 3);
  stops.resize(10);
  const auto run = [&](std::uint64_t seed) {
    MonteCarlo filter = lost_in_the_flat(model, seed);
    follow(filter, stops);
    StateHash hash;
    for (std::size_t i = 0; i < filter.particles().size(); ++i) {
      hash.add(filter.particles().x[i]);
      hash.add(filter.particles().theta[i]);
      hash.add(filter.particles().weight[i]);
    }
    return hash.value();
  };
  EXPECT_EQ(run(7), run(7));
  EXPECT_NE(run(7), run(8));
}

TEST(MonteCarlo, FindsARobotAgainThatSomebodyCarriedAway) {
  const robot::RobotModel model = scanner("realistic");
  const std::vector<Stop> stops = tour_of(model, 11);
  MonteCarlo filter = lost_in_the_flat(model, 11);
  filter.start_at(stops[0].truth, 0.05, 0.05);
  const std::vector<Stop> begin(stops.begin(), stops.begin() + 40);
  follow(filter, begin);
  ASSERT_TRUE(knows(filter, begin.back().truth));
  // From the 40th stop to the 80th in no time; its odometry does not notice.
  follow(filter, stops, 80);
  EXPECT_TRUE(knows(filter, stops.back().truth));

  MonteCarloSettings stubborn = filter.settings();
  stubborn.slow_rate = 0;
  const auto walls = walls_in(flat(), kCell);
  MonteCarlo other(std::make_shared<const LikelihoodField>(walls, BeamSettings{}),
                   room_for(flat(), walls, model.radius()), stubborn, 11);
  other.start_at(stops[0].truth, 0.05, 0.05);
  follow(other, begin);
  follow(other, stops, 80);
  EXPECT_EQ(other.lost_share(), 0);
  EXPECT_FALSE(knows(other, stops.back().truth));
}

TEST(MonteCarlo, TakesTheHeaviestClusterAndItsMean) {
  const auto walls = walls_in(flat(), kCell);
  MonteCarloSettings settings;
  settings.least_particles = 4000;
  MonteCarlo filter(std::make_shared<const LikelihoodField>(walls, BeamSettings{}),
                    room_for(flat(), walls, 0.1), settings, 5);
  // About pi: headings of both signs.
  filter.start_at({1.2, 1.6, kPi}, 0.06, 0.1);
  const Cluster cluster = filter.estimate();
  EXPECT_GT(cluster.share, 0.95);
  EXPECT_LT(distance(cluster.estimate.pose, {1.2, 1.6, kPi}), 0.005);
  EXPECT_LT(turn_between(cluster.estimate.pose, {1.2, 1.6, kPi}), 0.01);
  EXPECT_NEAR(cluster.estimate.covariance(0, 0), 0.0036, 0.0004);
  EXPECT_NEAR(cluster.estimate.covariance(1, 1), 0.0036, 0.0004);
  EXPECT_NEAR(cluster.estimate.covariance(2, 2), 0.01, 0.001);
  EXPECT_NEAR(cluster.estimate.covariance(0, 1), 0.0, 0.0004);
}

TEST(MonteCarlo, GoesByTheLastScanAloneWhereNobodyFitsAll) {
  // One post, and two particles, each of which one of two scans says the post is before.
  mapping::Raster<std::uint8_t> post({{0, 0}, kCell, 80, 80});
  const Vec2 place{2.025, 2.025};
  post[post.geometry.cell_at(place)] = 1;
  MonteCarloSettings settings;
  settings.least_particles = 2;
  settings.beam_exponent = 1.0;
  settings.resample_below = 0.0;
  settings.slow_rate = 0.0;
  MonteCarlo filter(std::make_shared<const LikelihoodField>(post, BeamSettings{}),
                    mapping::Raster<std::uint8_t>(post.geometry, 1), settings, 1);
  filter.start_at({1.0, 1.0, 0.0}, 0.3, 0.0);
  const Particles& both = filter.particles();
  ASSERT_EQ(both.size(), 2U);
  ASSERT_GT(distance(both.pose(0), both.pose(1)), 0.3);
  const auto seen_from = [&](std::size_t i) {
    Scan scan;
    scan.hits.assign(1000, place - both.pose(i).position());
    return scan;
  };
  filter.correct(seen_from(0));
  EXPECT_EQ(both.weight, (std::vector<double>{1.0, 0.0})) << "so unlikely that nothing is left";
  filter.correct(seen_from(1));
  EXPECT_EQ(both.weight, (std::vector<double>{0.0, 1.0}));
}

TEST(MonteCarlo, LearnsNothingFromAScanThatMetNothing) {
  MonteCarlo filter = lost_in_the_flat(scanner("perfect"), 1);
  const std::vector<double> before = filter.particles().weight;
  filter.correct({});
  EXPECT_EQ(filter.particles().weight, before);
}

TEST(MonteCarlo, RefusesSettingsThatCannotBe) {
  const auto walls = walls_in(flat(), kCell);
  const auto field = std::make_shared<const LikelihoodField>(walls, BeamSettings{});
  const auto free = room_for(flat(), walls, 0.1);
  MonteCarloSettings bad;
  bad.least_particles = 0;
  EXPECT_THROW(MonteCarlo(field, free, bad, 1), std::invalid_argument);
  bad = {};
  bad.fast_rate = bad.slow_rate;
  EXPECT_THROW(MonteCarlo(field, free, bad, 1), std::invalid_argument);
  EXPECT_THROW(MonteCarlo(nullptr, free, {}, 1), std::invalid_argument);
  EXPECT_THROW(MonteCarlo(field, mapping::Raster<std::uint8_t>(free.geometry), {}, 1),
               std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::localisation
