// What is said about how likely readings are: sums of 1, and what the simulated sensors do.
#include "eyebridge/robot/sensor_likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "likelihood_fit.hpp"
#include "rig.hpp"
#include "sensing.hpp"

namespace eyebridge::robot {
namespace {

using namespace eyebridge::testing;

constexpr double kNever = std::numeric_limits<double>::infinity();

struct RangeCase {
  std::string name;
  RangeSensorModel model;
  unsigned talkers = 0;
};

std::vector<RangeCase> range_cases() {
  std::vector<RangeCase> cases;
  const auto add = [&](const char* name, RangeError error) -> RangeCase& {
    RangeCase one{name, {}, 0};
    one.model.error = error;
    one.model.max_range = 3.0;
    one.model.min_range = 0.1;
    cases.push_back(one);
    return cases.back();
  };
  add("exact", {});
  add("bias", {{0.05, 0, 0}});
  add("gaussian", {{0.01, 0.04, 0.02}, 0.1});
  add("all the range", {{0, 0.5, 0}, 0.02});
  const RangeTable table({0.2, 0.5, 0.9, 1.0, 1.1, 1.2, 1.4, 2.0, 2.2});
  add("table", {{0, 0.05, 0.02}, 0.05, true}).model.table = table;
  add("exact table", {{}, 0, true}).model.table = table;
  add("lost where it ends", {{0, 0.03, 0}}).model.out_of_range = 3.0;
  RangeCase sonar = add("sonar", {{0, 0.02, 0.01}, 0.05, false, 0.4});
  sonar.model.kind = RangeKind::Ultrasound;
  for (const unsigned talkers : {0u, 1u, 3u}) {
    sonar.talkers = talkers;
    cases.push_back(sonar);
  }
  sonar.model.error.cross_talk = 1.0;
  cases.push_back(sonar);
  sonar.model.error = {{}, 0.0, true, 0.3};
  sonar.model.table = table;
  cases.push_back(sonar);
  RangeCase infrared = add("infrared", {{0, 0.001, 0}, 0.03, false, 0, 0.05});
  infrared.model.kind = RangeKind::Infrared;
  infrared.model.min_range = 0.4;
  cases.push_back(infrared);
  return cases;
}

constexpr double kDistances[] = {0.0, 0.05, 0.2, 0.4, 1.02, 2.15, 2.95, 5.0, kNever};

/// Of the density, by the midpoints of slices: off by half a slice where it has a step.
double integral(const RangeReadings& readings, double end) {
  constexpr int kSlices = 20000;
  double sum = 0.0;
  for (int i = 0; i < kSlices; ++i) sum += readings.density((i + 0.5) * end / kSlices);
  return sum * end / kSlices;
}

TEST(RangeLikelihood, DensityAndMassesSumUpToOne) {
  for (const RangeCase& c : range_cases()) {
    for (const double distance : kDistances) {
      const RangeReadings readings(c.model, distance, c.talkers);
      const std::vector<double> levels = c.model.table.levels();
      std::set<double> special(levels.begin(), levels.end());
      const double read = c.model.kind == RangeKind::Infrared && distance != kNever
                              ? folded_range(distance, c.model)
                              : distance;
      special.insert({0.0, c.model.max_range, c.model.out_of_range});
      special.insert(std::clamp(read + c.model.error.bias, 0.0, c.model.max_range));
      double masses = 0.0;
      for (const double reading : special) masses += readings.mass(reading);
      EXPECT_NEAR(masses + integral(readings, c.model.max_range), 1.0, 1e-4)
          << c.name << " with " << c.talkers << " at " << distance;
    }
  }
}

TEST(RangeLikelihood, ReadingsOfAnyResolutionSumUpToOne) {
  for (const RangeCase& c : range_cases()) {
    for (const double distance : kDistances) {
      const RangeReadings readings(c.model, distance, c.talkers);
      for (const double resolution : {0.001, 0.037, 1.0}) {
        double sum = 0.0;
        for (int i = -1; i * resolution < 11; ++i) {
          const double one = readings.probability(i * resolution, resolution);
          ASSERT_GE(one, -1e-12) << c.name << " at " << distance;
          sum += one;
        }
        EXPECT_NEAR(sum, 1.0, 1e-9) << c.name << " at " << distance;
      }
    }
  }
}

// An echo that comes at once is one: a sensor that reads too little often says 0.
TEST(RangeLikelihood, AReadingOfNothingIsAnEchoToo) {
  RangeSensorModel model;
  model.max_range = 4.0;
  model.error.bias = -0.01;
  model.error.sigma = 0.02;
  const RangeReadings readings(model, 0.01);
  EXPECT_NEAR(readings.at_most(0.0), 0.5, 1e-9);
}

TEST(RangeLikelihood, DensityIsTheSlopeOfTheDistribution) {
  for (const RangeCase& c : range_cases()) {
    if (!c.model.table.empty() || c.model.error.sigma == 0) continue;
    for (const double distance : kDistances) {
      const RangeReadings readings(c.model, distance, c.talkers);
      for (double r = 0.0313; r < 2.99; r += 0.0171) {
        const double slope = (readings.at_most(r + 1e-6) - readings.at_most(r - 1e-6)) / 2e-6;
        ASSERT_NEAR(readings.density(r), slope, 1e-4 * std::max(1.0, slope))
            << c.name << " at " << distance << ", reading " << r;
      }
    }
  }
}

TEST(RangeLikelihood, IsWhatEverySimulatedReadingIsDrawnFrom) {
  // Shifted by 1e-9, no end of a bin is a reading: the last bit of neither side counts.
  for (const RangeCase& c : range_cases()) {
    for (const double distance : kDistances) {
      if (distance == kNever) continue;
      Random random(17);
      std::vector<double> sample(20000);
      const double read =
          c.model.kind == RangeKind::Infrared ? folded_range(distance, c.model) : distance;
      for (double& reading : sample) reading = range_reading(read, c.model, random, c.talkers);
      const RangeReadings readings(c.model, distance, c.talkers);
      EXPECT_GT(p_value(sample, -1e-9, c.model.max_range + 1e-9,
                        [&](double r) { return readings.at_most(r); }),
                kUnlikely)
          << c.name << " with " << c.talkers << " at " << distance;
      // The test itself can tell: readings of another distance they are not.
      const RangeReadings others(c.model, distance + 0.5, c.talkers);
      if (distance > 0.3 && distance < 2.3) {
        EXPECT_LT(p_value(sample, -1e-9, c.model.max_range + 1e-9,
                          [&](double r) { return others.at_most(r); }),
                  kUnlikely)
            << c.name << " with " << c.talkers << " at " << distance;
      }
    }
  }
}

TEST(RangeLikelihood, HoldsForSensorsOfARobotInARoom) {
  // Two robots that face each other 1.8 m apart, and an infrared sensor that is too near to a wall.
  RobotModel model;
  model.range_sensors.resize(2);
  model.range_sensors[0].kind = RangeKind::Ultrasound;
  model.range_sensors[0].error = {{0.01, 0.02, 0.0}, 0.05, false, 0.3};
  model.range_sensors[0].max_range = 3.0;
  model.range_sensors[1].kind = RangeKind::Infrared;
  model.range_sensors[1].error = {{0.0, 0.001, 0.0}, 0.02, false, 0.0, 0.1};
  model.range_sensors[1].pose_in_robot = {0.0, 0.0, kPi};
  model.range_sensors[1].min_range = 0.3;
  model.range_sensors[1].max_range = 1.5;
  Rig rig(model, {0.2, 2.0, 0.0});
  rig.sim.add_robot(model, {2.0, 2.0, kPi});
  const unsigned talkers = rig.sim.cross_talkers(rig.robot, 0);
  ASSERT_EQ(talkers, 1u);
  const double distances[] = {1.8 - model.radius(), 0.2};
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<double> sample(20000);
    for (double& range : sample) range = rig.sim.read_range(rig.robot, i);
    const RangeReadings readings(model.range_sensors[i], distances[i], talkers);
    EXPECT_GT(p_value(sample, -1e-9, 3.0, [&](double r) { return readings.at_most(r); }), kUnlikely)
        << i;
  }
}

TEST(LidarLikelihood, IsWhatSimulatedRaysAreDrawnFrom) {
  RobotModel model;
  model.lidar = LidarModel{};
  model.lidar->max_range = 2.05;
  model.lidar->error = {{0.01, 0.02, 0.01}, 0.04};
  Rig rig(model, {3.0, 1.5, 0.0});
  std::vector<std::vector<double>> samples(4);
  std::vector<double> scan(4);  // behind: nothing in reach; left: nothing; ahead 1 m; right 1.5 m
  for (int i = 0; i < 20000; ++i) {
    rig.sim.read_lidar(rig.robot, 2 * kPi, scan);
    for (std::size_t ray = 0; ray < 4; ++ray) samples[ray].push_back(scan[ray]);
  }
  const double distances[] = {3.0, 2.5, 1.0, 1.5};
  for (std::size_t ray = 0; ray < 4; ++ray) {
    const RangeReadings readings(*model.lidar, distances[ray]);
    EXPECT_GT(
        p_value(samples[ray], -1e-9, 2.05 + 1e-9, [&](double r) { return readings.at_most(r); }),
        kUnlikely)
        << ray;
    EXPECT_NEAR(integral(readings, 2.05) + readings.mass(0.0) + readings.mass(2.05), 1.0, 1e-6);
  }
  EXPECT_EQ(RangeReadings(*model.lidar, 3.0).mass(2.05), 1.0) << "nothing met has no noise";
}

TEST(CompassLikelihood, IsWhatSimulatedReadingsAreDrawnFromAllRoundTheCircle) {
  for (const double sigma : {0.05, 0.6, 2.5}) {
    for (const double heading : {0.3, 3.1, -2.0}) {
      RobotModel model;
      model.compass_error = {{0.2, sigma, 0.1}};
      Rig rig(model, {2, 2, heading});
      std::vector<double> sample(20000);
      for (double& reading : sample) reading = rig.sim.read_compass(rig.robot);
      const HeadingReadings readings(model.compass_error, heading);
      const auto at_most = [&](double reading) {
        const double width = std::clamp(reading, -kPi, kPi) + kPi;
        return width > 0 ? readings.probability(-kPi + width / 2, width) : 0.0;
      };
      EXPECT_GT(p_value(sample, -kPi, kPi, at_most), kUnlikely) << sigma << " at " << heading;
      double sum = 0.0;
      for (int i = 0; i < 20000; ++i) sum += readings.density(-kPi + (i + 0.5) * kPi / 10000);
      EXPECT_NEAR(sum * kPi / 10000, 1.0, 1e-9);
      EXPECT_NEAR(readings.probability(1.0, 2 * kPi), 1.0, 1e-12);
    }
  }
}

TEST(CompassLikelihood, OfAnExactOneIsCertain) {
  const HeadingReadings readings(CompassError{}, 1.0 + 2 * kPi);
  EXPECT_EQ(readings.mass(wrap_angle(1.0 + 2 * kPi)), 1.0);
  EXPECT_EQ(readings.mass(0.9), 0.0);
  EXPECT_EQ(readings.probability(0.99, 0.1), 1.0);
  EXPECT_EQ(readings.probability(0.9, 0.1), 0.0);
  EXPECT_EQ(HeadingReadings(CompassError{}, kPi).probability(-kPi + 0.01, 0.1), 1.0)
      << "across the seam";
}

TEST(GyroscopeLikelihood, IsWhatSimulatedReadingsAreDrawnFromAfterAnyTime) {
  RobotModel model;
  model.gyroscope_error = {{0.01, 0.02, 0.05}, 0.01};
  std::vector<double> sample(3000);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    SimulationSettings settings;
    settings.seed = i + 1;
    settings.step = 0.1;
    Rig rig(model, {2, 2, 0}, settings);
    rig.sim.set_speed(rig.robot, {0.0, 0.5});
    rig.steps(90);
    sample[i] = rig.sim.read_gyroscope(rig.robot);
  }
  const NormalReadings readings(model.gyroscope_error, 0.5, 9.0);
  EXPECT_GT(p_value(sample, 0.2, 0.8, [&](double r) { return readings.at_most(r); }), kUnlikely);
  const NormalReadings fresh(model.gyroscope_error, 0.5, 0.0);
  EXPECT_LT(p_value(sample, 0.2, 0.8, [&](double r) { return fresh.at_most(r); }), kUnlikely);
}

TEST(AccelerometerLikelihood, IsWhatSimulatedReadingsAreDrawnFrom) {
  RobotModel model;
  model.accelerometer_error = {{0.1, 0.05, 0.2}};
  Rig rig(model);
  rig.sim.set_speed(rig.robot, {0.3, 0.0});
  rig.steps(10);
  std::vector<double> sample(20000);
  for (double& felt : sample) felt = rig.sim.read_accelerometer(rig.robot).x;
  const NormalReadings readings(model.accelerometer_error, 1.0);
  EXPECT_GT(p_value(sample, 0.0, 2.2, [&](double r) { return readings.at_most(r); }), kUnlikely);
  double sum = 0.0;
  for (int i = 0; i < 10000; ++i) sum += readings.density(-1 + (i + 0.5) * 4e-4) * 4e-4;
  EXPECT_NEAR(sum, 1.0, 1e-9);
}

TEST(SwitchLikelihood, SumsUpToOne) {
  const ProximityError ir{0.1};
  const BumperError bumper{0.2};
  for (const bool truth : {false, true}) {
    EXPECT_DOUBLE_EQ(probability(ir, false, truth) + probability(ir, true, truth), 1.0);
    EXPECT_DOUBLE_EQ(probability(bumper, false, truth) + probability(bumper, true, truth), 1.0);
  }
  EXPECT_EQ(probability(ir, true, false), 0.1);
  EXPECT_EQ(probability(bumper, true, false), 0.0) << "no contact is invented";
  EXPECT_EQ(probability(bumper, false, true), 0.2);
}

}  // namespace
}  // namespace eyebridge::robot
