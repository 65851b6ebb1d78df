#include "eyebridge/mapping/beam_model.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "bad_numbers.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/robot/error_presets.hpp"

namespace eyebridge::mapping {
namespace {

BeamModel two_metres(double sigma = 0.0) {
  BeamModel model;
  model.max_range = 2.0;
  model.out_of_range = 9.999;
  model.sigma = sigma;
  return model;
}

TEST(BeamModel, WithoutErrorIsFreeThenOccupiedThenUnknown) {
  const BeamModel model = two_metres();
  EXPECT_NEAR(model.probability(1.0, 0.90, 0.95), 0.35, 1e-6);
  EXPECT_NEAR(model.probability(1.0, 0.975, 1.025), 0.85, 1e-6);
  EXPECT_NEAR(model.probability(1.0, 1.05, 1.10), 0.5, 1e-6);
}

TEST(BeamModel, IsTheMeanOverWhereTheSurfaceMayBe) {
  // One cell from 0.9 to 1.1 m and a reading of 1 m: with sigma 0.1 m, 68.27 % of surfaces lie in
  // it, 15.87 % nearer, as many farther.
  const double expected = 0.6826895 * 0.85 + 0.1586553 * 0.5 + 0.1586553 * 0.35;
  EXPECT_NEAR(two_metres(0.1).probability(1.0, 0.9, 1.1), expected, 1e-6);
  // All probability goes somewhere: cells in a row share the surface.
  double shares = 0.0;
  for (int i = 0; i < 40; ++i) {
    const double p = two_metres(0.1).probability(1.0, 0.05 * i, 0.05 * (i + 1));
    const double centre = 0.05 * i + 0.025;
    EXPECT_GT(p, 0.34) << centre;
    EXPECT_LT(p, 0.86) << centre;
    const double before = 0.5 * std::erfc(-(0.05 * i - 1.0) / (0.1 * std::sqrt(2.0)));
    const double up_to = 0.5 * std::erfc(-(0.05 * (i + 1) - 1.0) / (0.1 * std::sqrt(2.0)));
    shares += (p - before * 0.5 - (1 - up_to) * 0.35) / 0.85;
  }
  EXPECT_NEAR(shares, 1.0, 1e-5);
}

TEST(BeamModel, OfASensorThatErrsMoreMovesTheBeliefLess) {
  const auto met = [](double sigma) { return two_metres(sigma).probability(1.0, 0.975, 1.025); };
  const auto crossed = [](double sigma) { return two_metres(sigma).probability(1.0, 0.6, 0.65); };
  double last_met = 0.86;
  double last_crossed = 0.34;
  for (const double sigma : {0.0, 0.02, 0.05, 0.1, 0.2}) {
    EXPECT_LT(met(sigma), last_met) << sigma;
    EXPECT_GE(crossed(sigma), last_crossed - 1e-7) << sigma;
    last_met = met(sigma);
    last_crossed = crossed(sigma);
  }
}

TEST(BeamModel, KnowsErrorsThatGrowWithTheSquareOfTheRange) {
  robot::RangeSensorModel sensor;
  sensor.error.sigma = 0.01;
  sensor.error.sigma_quadratic = 0.02;
  const BeamModel model = beam_model_of(sensor);
  EXPECT_DOUBLE_EQ(model.sigma_at(2.0), 0.01 + 0.02 * 4);
  EXPECT_DOUBLE_EQ(model.sigma_at(2.0), sensor.error.sigma_at(2.0));
}

TEST(BeamModel, OutOfRangeMeansFreeAsFarAsDropoutLetsIt) {
  BeamModel model = two_metres();
  model.min_range = 0.1;
  for (const double range : {2.0, 5.0, 9.999, kInfinite}) {
    EXPECT_NEAR(model.probability(range, 1.0, 1.05), 0.35, 1e-12) << range;
    EXPECT_EQ(model.probability(range, 0.02, 0.07), 0.5) << "it may be nearer than it can see";
  }
  // Of readings out of range, half of the beams meet nothing, and dropout of the other half.
  model.dropout = 0.25;
  const double told = 0.5 / (0.5 + 0.5 * 0.25);
  EXPECT_NEAR(model.probability(2.0, 1.0, 1.05), told * 0.35 + (1 - told) * 0.5, 1e-12);
  model.dropout = 1.0;
  EXPECT_NEAR(model.probability(2.0, 1.0, 1.05), 0.425, 1e-12);
}

TEST(BeamModel, PassesOverReadingsThatSayNothing) {
  for (const double range : {kNotANumber, -kInfinite, -1e-9, -3.0}) {
    EXPECT_FALSE(BeamModel::is_reading(range));
    EXPECT_EQ(two_metres(0.1).probability(range, 0.5, 0.55), 0.5) << range;
  }
  EXPECT_TRUE(BeamModel::is_reading(kInfinite));
  EXPECT_TRUE(BeamModel::is_reading(0.0));
}

TEST(BeamModel, TakesTheBiasOff) {
  BeamModel model = two_metres(0.01);
  const double straight = model.probability(1.0, 0.96, 1.01);
  model.bias = 0.2;
  EXPECT_NEAR(model.probability(1.2, 0.96, 1.01), straight, 1e-12);
}

TEST(BeamModel, CountsTheRoundingToATableAsError) {
  BeamModel model = two_metres(0.003);
  model.levels = {0.1, 0.2, 0.4, 0.8};
  EXPECT_NEAR(model.sigma_at(0.4), std::sqrt(0.003 * 0.003 + 0.4 * 0.4 / 12), 1e-12);
  EXPECT_NEAR(model.sigma_at(0.15), std::sqrt(0.003 * 0.003 + 0.1 * 0.1 / 12), 1e-12);
  EXPECT_NEAR(model.sigma_at(5.0), std::sqrt(0.003 * 0.003 + 0.4 * 0.4 / 12), 1e-12);
  model.levels = {0.5};
  EXPECT_EQ(model.sigma_at(0.5), 0.003);
}

TEST(BeamModel, LeavesDoubtNearASensorThatMayFold) {
  BeamModel model = two_metres();
  model.min_range = 0.2;
  model.fold = 0.3;
  const double far = model.probability(1.0, 0.6, 0.65);
  const double near = model.probability(1.0, 0.1, 0.15);
  EXPECT_NEAR(far, 0.7 * 0.35 + 0.3 * 0.5, 1e-9);
  EXPECT_GT(near, far);
  EXPECT_LT(model.probability(1.0, 0.975, 1.025), 0.85);
}

TEST(BeamModel, ComesFromTheSensorsOwnErrors) {
  robot::RobotModel robot;
  robot.range_sensors.resize(1);
  robot.range_sensors[0].min_range = 0.05;
  robot.range_sensors[0].max_range = 1.5;
  robot.lidar.emplace();
  robot::set_errors(robot, robot::error_preset("realistic").value());
  robot.range_sensors[0].table = robot::RangeTable({0.1, 0.3});
  const BeamModel psd = beam_model_of(robot.range_sensors[0]);
  EXPECT_EQ(psd.min_range, 0.05);
  EXPECT_EQ(psd.max_range, 1.5);
  EXPECT_EQ(psd.sigma, 0.003);
  EXPECT_EQ(psd.dropout, 0.002);
  EXPECT_EQ(psd.levels, (std::vector<double>{0.1, 0.3}));
  const BeamModel lidar = beam_model_of(*robot.lidar);
  EXPECT_EQ(lidar.max_range, robot.lidar->max_range);
  EXPECT_EQ(lidar.sigma_relative, 0.01);
  EXPECT_EQ(lidar.dropout, 0.005);
}

TEST(BeamModel, OfATiltedLidarEndsBeforeTheFloor) {
  robot::LidarModel lidar;
  lidar.tilt = deg_to_rad(30);
  lidar.height = 0.5;  // the beam is 1 m long
  EXPECT_NEAR(beam_model_of(lidar).max_range, std::sqrt(0.75), 1e-9);
  lidar.error.sigma = 0.02;
  EXPECT_NEAR(beam_model_of(lidar).max_range, 0.94 * std::sqrt(0.75), 1e-9);
  EXPECT_NEAR(level_range(lidar, 0.8), 0.8 * std::sqrt(0.75), 1e-9);
  lidar.tilt = deg_to_rad(-30);
  EXPECT_NEAR(beam_model_of(lidar).max_range, lidar.max_range * std::sqrt(0.75), 1e-9);
}

TEST(BeamModel, RefusesWhatCannotBe) {
  const auto refusal = [](auto change) -> std::string {
    BeamModel model = two_metres();
    change(model);
    try {
      model.check();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal([](BeamModel&) {}), "accepted");
  EXPECT_EQ(refusal([](BeamModel& m) { m.max_range = kInfinite; }),
            "beam model: the reach is not a positive length");
  EXPECT_EQ(refusal([](BeamModel& m) { m.min_range = 2.0; }),
            "beam model: the least range is not 0 to the reach");
  EXPECT_EQ(refusal([](BeamModel& m) { m.sigma = -0.1; }), "beam model: sigma is no length");
  EXPECT_EQ(refusal([](BeamModel& m) { m.dropout = kNotANumber; }),
            "beam model: dropout is not 0 to 1");
  EXPECT_EQ(refusal([](BeamModel& m) { m.crossed = 0.5; }),
            "beam model: crossed is not between 0 and 1/2");
  EXPECT_EQ(refusal([](BeamModel& m) { m.met = 1.0; }), "beam model: met is not between 1/2 and 1");
  EXPECT_EQ(refusal([](BeamModel& m) {
              m.levels = {0.2, 0.1};
            }),
            "beam model: the levels do not ascend");
}

}  // namespace
}  // namespace eyebridge::mapping
