// What is said about how likely counts of an encoder are, and what simulated ones count.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/robot/sensor_likelihood.hpp"
#include "likelihood_fit.hpp"
#include "rig.hpp"

namespace eyebridge::robot {
namespace {

using testing::kUnlikely;

/// What the left encoder says after a drive that takes it past `ticks` ticks, for many seeds.
std::vector<double> counts_after(const RobotModel& model, double speed, double seconds) {
  std::vector<double> sample(3000);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    SimulationSettings settings;
    settings.seed = i + 1;
    settings.step = 0.1;
    Rig rig(model, {2, 2, 0}, settings);
    rig.sim.set_wheel(rig.robot, 0, speed);
    rig.sim.set_wheel(rig.robot, 1, -speed);
    rig.steps(static_cast<int>(std::lround(seconds / settings.step)));
    sample[i] = static_cast<double>(rig.sim.encoder_ticks(rig.robot, 0));
  }
  return sample;
}

TEST(EncoderLikelihood, IsWhatSimulatedEncodersCount) {
  RobotModel model;
  model.drive.motor_time_constant = 0.0;
  model.drive.ticks_per_revolution = 540.0;
  for (const double miss : {0.02, 0.3, 0.9}) {
    for (const double speed : {2.0, -2.0}) {
      model.drive_error.encoder_miss = miss;
      const std::vector<double> sample = counts_after(model, speed, 1.0);
      const auto readings = [&](double angle) {
        return TickReadings(model.drive_error, 540.0, angle);
      };
      const auto fits = [&](const TickReadings& of) {
        const auto at_most = [&](double r) {
          return of.at_most(static_cast<std::int64_t>(std::floor(std::clamp(r, -1e6, 1e6))));
        };
        return p_value(sample, speed > 0 ? -0.5 : -180.5, speed > 0 ? 180.5 : 0.5, at_most);
      };
      EXPECT_GT(fits(readings(speed)), kUnlikely) << miss << " at " << speed;
      EXPECT_LT(fits(readings(speed * 1.1)), kUnlikely) << miss << " at " << speed;
      EXPECT_LT(fits(readings(-speed)), kUnlikely) << miss << " at " << speed;
    }
  }
}

TEST(EncoderLikelihood, SumsUpToOneAndIsBinomial) {
  DriveError error;
  error.encoder_miss = 0.25;
  const TickReadings four(error, 100.0, 2 * kPi * 0.04);  // four ticks
  const double expected[] = {1.0, 12.0, 54.0, 108.0, 81.0};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(four.mass(i), expected[i] / 256, 1e-12) << i;
  EXPECT_EQ(four.mass(-1), 0.0) << "no tick is invented";
  EXPECT_EQ(four.mass(5), 0.0);
  EXPECT_NEAR(four.probability(3.2, 2.0), (108.0 + 81.0) / 256, 1e-12);
  EXPECT_NEAR(TickReadings(error, 100.0, -2 * kPi * 0.04).mass(-3), 108.0 / 256, 1e-12);
  for (const double miss : {1e-6, 0.005, 0.5, 0.999}) {
    error.encoder_miss = miss;
    for (const double angle : {0.0, 0.1, -30.0, 7000.0}) {
      const TickReadings readings(error, 1100.0, angle);
      const auto all = std::llround(angle / (2 * kPi) * 1100);
      double sum = 0.0;
      double mean = 0.0;
      for (std::int64_t ticks = std::min<std::int64_t>(all, 0);
           ticks <= std::max<std::int64_t>(all, 0); ++ticks) {
        sum += readings.mass(ticks);
        mean += static_cast<double>(ticks) * readings.mass(ticks);
      }
      EXPECT_NEAR(sum, 1.0, 1e-9) << miss << " of " << angle;
      EXPECT_NEAR(mean, static_cast<double>(all) * (1 - miss), 1e-9 * std::abs(mean) + 1e-9);
      EXPECT_NEAR(readings.at_most(std::max<std::int64_t>(all, 0)), 1.0, 1e-12);
      EXPECT_EQ(readings.at_most(std::min<std::int64_t>(all, 0) - 1), 0.0);
    }
  }
}

TEST(EncoderLikelihood, OfAnExactOneIsCertain) {
  for (const double angle : {0.0, 12.34, -12.34}) {
    const TickReadings readings(DriveError{}, 1000.0, angle);
    EXPECT_EQ(readings.mass(std::llround(angle / (2 * kPi) * 1000)), 1.0);
    EXPECT_EQ(readings.mass(std::llround(angle / (2 * kPi) * 1000) + 1), 0.0);
  }
  DriveError blind;
  blind.encoder_miss = 1.0;
  EXPECT_EQ(TickReadings(blind, 1000.0, 5.0).mass(0), 1.0);
}

TEST(EncoderLikelihood, RefusesWhatCannotBe) {
  EXPECT_THROW(TickReadings({}, 0.0, 1.0), std::invalid_argument);
  EXPECT_THROW(TickReadings({}, 1000.0, 1e300), std::invalid_argument);
  EXPECT_THROW(TickReadings({}, 1000.0, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::robot
