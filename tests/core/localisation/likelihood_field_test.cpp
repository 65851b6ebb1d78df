#include "eyebridge/localisation/likelihood_field.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tour.hpp"

namespace eyebridge::localisation {
namespace {

/// 20 x 10 cells of 10 cm, occupied at (5, 5), whose centre is (1.55, 2.55).
mapping::Raster<std::uint8_t> one_cell() {
  mapping::Raster<std::uint8_t> map({{1, 2}, 0.1, 20, 10});
  map[{5, 5}] = 1;
  return map;
}

double expected_log(double distance, const BeamSettings& s) {
  const double hit =
      std::exp(-0.5 * distance * distance / (s.sigma * s.sigma)) / (s.sigma * std::sqrt(2 * kPi));
  return std::log(s.z_hit * hit + s.z_random / s.max_range);
}

TEST(LikelihoodField, IsTheMixtureOfTheBook) {
  const BeamSettings settings{0.15, 0.8, 0.2, 4.0};
  const LikelihoodField field(one_cell(), settings);
  EXPECT_NEAR(field.at({1.57, 2.52}), expected_log(0.0, settings), 1e-6);
  EXPECT_NEAR(field.highest(), expected_log(0.0, settings), 1e-12);
  EXPECT_NEAR(field.at({1.85, 2.55}), expected_log(0.3, settings), 1e-6);
  EXPECT_NEAR(field.at({1.85, 2.95}), expected_log(0.5, settings), 1e-6);
}

TEST(LikelihoodField, OutsideTheMapOnlyChanceBeamsEnd) {
  const BeamSettings settings{0.15, 0.8, 0.2, 4.0};
  const LikelihoodField field(one_cell(), settings);
  for (const Vec2 place :
       {Vec2{0.999, 2.5}, Vec2{3.001, 2.5}, Vec2{1.5, 1.999}, Vec2{1.5, 3.001}, Vec2{-1e9, 1e9}}) {
    EXPECT_NEAR(field.at(place), std::log(0.05), 1e-6) << place.x << ", " << place.y;
  }
}

TEST(LikelihoodField, SumsTheBeamsOfEveryParticle) {
  const LikelihoodField field(testing::walls_in(testing::flat(), 0.05), {});
  Random random(8);
  std::vector<Vec2> hits;
  for (int i = 0; i < 61; ++i) hits.push_back({4 * random.uniform() - 2, 4 * random.uniform() - 2});
  Particles particles;
  for (int i = 0; i < 50; ++i) {
    particles.add({4 * random.uniform(), 3 * random.uniform(), 6 * random.uniform()}, 0.02);
  }
  std::vector<double> sums(particles.size());
  field.log_likelihoods(particles, hits, sums);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    double expected = 0;
    const Pose pose = particles.pose(i);
    for (const Vec2 hit : hits) {
      expected += field.at(transform(pose, {hit.x, hit.y, 0}).position());
    }
    EXPECT_NEAR(sums[i], expected, 1e-9);
  }
}

TEST(LikelihoodField, IsHighestWhereTheScanWasTaken) {
  const LikelihoodField field(testing::walls_in(testing::flat(), 0.05), {});
  const auto stops = testing::tour_of(testing::scanner("perfect"), 1);
  for (std::size_t i = 0; i < stops.size(); i += 10) {
    const auto& [truth, odometry, scan] = stops[i];
    const double best = field.log_likelihood(truth, scan.hits);
    for (const Pose& off :
         {Pose{0.1, 0, 0}, Pose{0, -0.1, 0}, Pose{0, 0, 0.1}, Pose{-0.2, 0.2, 3}}) {
      EXPECT_GT(best, field.log_likelihood(transform(truth, off), scan.hits)) << "stop " << i;
    }
  }
}

TEST(LikelihoodField, RefusesSettingsThatCannotBe) {
  EXPECT_THROW(LikelihoodField({}, {}), std::invalid_argument);
  EXPECT_THROW(LikelihoodField(one_cell(), {0.0, 0.9, 0.1, 10}), std::invalid_argument);
  EXPECT_THROW(LikelihoodField(one_cell(), {0.1, 0.9, 0.0, 10}), std::invalid_argument);
  EXPECT_THROW(LikelihoodField(one_cell(), {0.1, 1.1, 0.1, 10}), std::invalid_argument);
  EXPECT_THROW(LikelihoodField(one_cell(), {0.1, 0.9, 0.1, NAN}), std::invalid_argument);
  EXPECT_THROW(LikelihoodField(one_cell(), {0.1, 0.9, 0.1, INFINITY}), std::invalid_argument);
  const LikelihoodField field(one_cell(), {0.1, 0.9, 0.1, 10});
  EXPECT_TRUE(std::isfinite(field.at({NAN, NAN}))) << "a place that is none lies nowhere else";
}

}  // namespace
}  // namespace eyebridge::localisation
