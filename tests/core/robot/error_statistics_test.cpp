// Mean, deviation and distribution of the errors of every sensor, with fixed seeds.
#include <vector>

#include <gtest/gtest.h>

#include "rig.hpp"
#include "statistics.hpp"

namespace eyebridge::robot {
namespace {

using namespace eyebridge::testing;

constexpr int kReadings = 20000;

/// A PSD that looks at the wall 2 m away, kReadings times.
std::vector<double> ranges(const RangeError& error, const RangeTable& table = {}) {
  RobotModel model;
  model.range_sensors.resize(1);
  model.range_sensors[0].error = error;
  model.range_sensors[0].table = table;
  Rig rig(model);
  std::vector<double> out(kReadings);
  for (double& range : out) range = rig.sim.read_range(rig.robot, 0);
  return out;
}

TEST(RangeErrors, GaussianAndBiasAreNormallyDistributed) {
  expect_normal(ranges({{0.05, 0.02, 0.0}}), 2.05, 0.02);
}

TEST(RangeErrors, ProportionalSigmaGrowsWithTheRange) {
  expect_normal(ranges({{0.0, 0.0, 0.03}}), 2.0, 0.06);
  expect_normal(ranges({{0.0, 0.01, 0.01}}), 2.0, 0.03);
}

TEST(RangeErrors, DropOutsReadOutOfRangeAsOftenAsAskedFor) {
  const auto sample = ranges({{0.0, 0.01, 0.0}, 0.07});
  const auto lost = std::count(sample.begin(), sample.end(), 9.999);
  EXPECT_GT(binomial_p_value(static_cast<double>(lost), kReadings, 0.07), kUnlikely);
  std::vector<double> seen;
  std::copy_if(sample.begin(), sample.end(), std::back_inserter(seen),
               [](double range) { return range < 9; });
  expect_normal(seen, 2.0, 0.01);
}

TEST(RangeErrors, DropOutsComeOneByOne) {
  const auto sample = ranges({{}, 0.5});
  std::vector<double> pairs(4);
  for (std::size_t i = 0; i + 1 < sample.size(); i += 2) {
    ++pairs[(sample[i] > 9 ? 2 : 0) + (sample[i + 1] > 9 ? 1 : 0)];
  }
  EXPECT_GT(chi_square_p_value(pairs, std::vector<double>(4, kReadings / 8.0)), kUnlikely);
}

TEST(RangeErrors, QuantisedReadingsAreEntriesOfTheTableAsOftenAsTheNoiseMakesThem) {
  // The last one stands for what is farther than half a step beyond the table.
  const std::vector<double> levels = {1.90, 1.96, 1.99, 2.02, 2.08, 9.999};
  const std::vector<double> ends = {1.93, 1.975, 2.005, 2.05, 2.11, 1e9};
  const auto sample = ranges({{0.0, 0.04, 0.0}, 0.0, true}, RangeTable(levels));
  std::vector<double> counts(levels.size());
  for (const double range : sample) {
    const auto at = std::find(levels.begin(), levels.end(), range);
    ASSERT_NE(at, levels.end()) << range;
    ++counts[static_cast<std::size_t>(at - levels.begin())];
  }
  std::vector<double> expected;
  double below = 0.0;
  for (const double end : ends) {
    const double up_to = normal_cdf(end, 2.0, 0.04);
    expected.push_back(kReadings * (up_to - below));
    below = up_to;
  }
  EXPECT_GT(chi_square_p_value(counts, expected), kUnlikely);
}

TEST(ProximityErrors, FlipsAreIndependentAndAsOftenAsAskedFor) {
  for (const double place : {2.0, 3.9}) {
    RobotModel model;
    model.proximity_sensors.resize(1);
    model.proximity_sensors[0].error.flip = 0.1;
    Rig rig(model, {place, 2.0, 0.0});
    const bool truth = place > 3;
    std::vector<double> pairs(4);
    for (int i = 0; i < kReadings; ++i) {
      const bool first = rig.sim.read_proximity(rig.robot, 0) != truth;
      const bool second = rig.sim.read_proximity(rig.robot, 0) != truth;
      ++pairs[(first ? 2 : 0) + (second ? 1 : 0)];
    }
    EXPECT_GT(chi_square_p_value(
                  pairs, {0.81 * kReadings, 0.09 * kReadings, 0.09 * kReadings, 0.01 * kReadings}),
              kUnlikely)
        << place;
  }
}

TEST(BumperErrors, MissesAsOftenAsAskedForAndNeverInventsAContact) {
  RobotModel model;
  model.bumpers = {{1, "ring", 0.0, 2 * kPi, {0.3}}};
  Rig rig(model, {4.0 - model.radius() - 1e-4, 2.0, 0.0});
  double missed = 0;
  for (int i = 0; i < kReadings; ++i) missed += rig.sim.read_bumper(rig.robot, 0) ? 0 : 1;
  EXPECT_GT(binomial_p_value(missed, kReadings, 0.3), kUnlikely);
  rig.sim.set_pose(rig.robot, {2.0, 2.0, 0.0});
  for (int i = 0; i < 1000; ++i) ASSERT_FALSE(rig.sim.read_bumper(rig.robot, 0));
}

/// Ranges of the ray straight ahead, and of one 2.5 times as far off.
struct Scans {
  std::vector<double> ahead;
  std::vector<double> aside;
};
Scans scans(const LidarError& error) {
  RobotModel model;
  model.lidar = LidarModel{};
  model.lidar->error = error;
  Rig rig(model, {3.0, 1.5, 0.0});
  Scans out;
  std::vector<double> ranges(4);  // behind, left, ahead, right
  for (int i = 0; i < kReadings; ++i) {
    rig.sim.read_lidar(rig.robot, 2 * kPi, ranges);
    out.ahead.push_back(ranges[2]);
    out.aside.push_back(ranges[1]);
  }
  return out;
}

TEST(LidarErrors, EveryRayIsNormallyDistributedByItsRange) {
  const Scans both = scans({{0.01, 0.005, 0.02}});
  expect_normal(both.ahead, 1.01, 0.025);
  expect_normal(both.aside, 2.51, 0.055);
}

TEST(LidarErrors, RaysOfOneScanAreIndependent) {
  const Scans both = scans({{0.0, 0.01, 0.0}});
  double covariance = 0.0;
  for (std::size_t i = 0; i < kReadings; ++i) {
    covariance += (both.ahead[i] - 1.0) * (both.aside[i] - 2.5) / kReadings;
  }
  EXPECT_NEAR(covariance / (0.01 * 0.01), 0.0, 4 / std::sqrt(double{kReadings}));
}

TEST(LidarErrors, DropOutsReadTheFullRange) {
  const Scans both = scans({{}, 0.04});
  const auto lost = std::count(both.ahead.begin(), both.ahead.end(), 9.999);
  EXPECT_GT(binomial_p_value(static_cast<double>(lost), kReadings, 0.04), kUnlikely);
  EXPECT_EQ(std::count(both.ahead.begin(), both.ahead.end(), 1.0), kReadings - lost);
}

TEST(CompassErrors, AreNormallyDistributedAboutTheHeading) {
  RobotModel model;
  model.compass_error.bias = -0.1;
  model.compass_error.sigma = 0.05;
  Rig rig(model, {2.0, 2.0, 1.0});
  std::vector<double> sample(kReadings);
  for (double& heading : sample) heading = rig.sim.read_compass(rig.robot);
  expect_normal(sample, 0.9, 0.05);
}

}  // namespace
}  // namespace eyebridge::robot
