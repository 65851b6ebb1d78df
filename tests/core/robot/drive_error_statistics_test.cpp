// Mean, deviation and distribution of what goes wrong with wheels and encoders, with fixed seeds.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "rig.hpp"
#include "statistics.hpp"

namespace eyebridge::robot {
namespace {

using namespace eyebridge::testing;

constexpr int kDrivenSteps = 10000;
constexpr double kSpeed = 0.3;             // metres per second
constexpr double kTravel = kSpeed * 0.01;  // of a wheel in a step, metres

RobotModel model_with(const DriveError& error, double ticks_per_step = 19.5) {
  RobotModel model;
  model.drive.linear_acceleration = 0.0;  // no ramp: every step is as long
  model.drive.angular_acceleration = 0.0;
  model.drive.ticks_per_revolution = ticks_per_step / kTravel * kPi * model.drive.wheel_diameter;
  model.drive_error = error;
  return model;
}

/// What the robot did in each of kDrivenSteps steps with speed `twist`, in a hall without
/// obstacles.
struct Way {
  std::vector<double> distances;
  std::vector<double> turns;
  std::vector<std::int64_t> ticks;  ///< Of the left wheel.
  Pose odometry;
};
Way drive(const RobotModel& model, const Twist& twist) {
  Simulation sim(room(200, 200), {});
  const RobotIndex robot = sim.add_robot(model, {100, 100, 0});
  sim.set_speed(robot, twist);
  Way way;
  Pose last = sim.pose(robot);
  std::int64_t last_ticks = 0;
  for (int i = 0; i < kDrivenSteps; ++i) {
    sim.step();
    const Pose pose = sim.pose(robot);
    way.distances.push_back(std::hypot(pose.x - last.x, pose.y - last.y));
    way.turns.push_back(wrap_angle(pose.theta - last.theta));
    way.ticks.push_back(sim.encoder_ticks(robot, 0) - last_ticks);
    last_ticks += way.ticks.back();
    last = pose;
  }
  way.odometry = sim.odometry(robot);
  return way;
}

TEST(DriveErrors, LinearSigmaSpreadsTheTravelOfAStep) {
  DriveError error;
  error.linear_sigma = 0.05;
  const Way way = drive(model_with(error), {kSpeed, 0.0});
  expect_normal(way.distances, kTravel, 0.05 * kTravel);
  EXPECT_NEAR(way.odometry.x, kDrivenSteps * kTravel, 1e-6) << "the wheels know nothing of it";
}

TEST(DriveErrors, AngularSigmaSpreadsTheTurnOfAStep) {
  DriveError error;
  error.angular_sigma = 0.1;
  const Way way = drive(model_with(error), {0.0, 2.0});
  expect_normal(way.turns, 0.02, 0.002);
}

TEST(DriveErrors, ScalesOfTheWheelsMakeAnExactCurve) {
  DriveError error;
  error.left_scale = -0.01;
  error.right_scale = 0.02;
  const RobotModel model = model_with(error);
  const Way way = drive(model, {kSpeed, 0.0});
  const Moments turns = moments_of(way.turns);
  EXPECT_NEAR(turns.mean, kTravel * 0.03 / model.drive.wheel_base, 1e-9);
  EXPECT_NEAR(turns.deviation, 0.0, 1e-9) << "systematic: no step differs";
}

TEST(DriveErrors, SlipTakesTheHoldOfEachWheelByItself) {
  constexpr double kSlip = 0.2;
  DriveError error;
  error.slip = kSlip;
  const RobotModel model = model_with(error);
  const Way way = drive(model, {kSpeed, 0.0});
  const double one_side = kTravel / model.drive.wheel_base;
  std::vector<double> cases(4);  // none, left, right, both
  for (std::size_t i = 0; i < kDrivenSteps; ++i) {
    const double turn = way.turns[i];
    if (std::abs(turn) > 1e-9) {
      EXPECT_NEAR(std::abs(turn), one_side, 1e-9);
      EXPECT_NEAR(way.distances[i], kTravel / 2, 1e-6);
      ++cases[turn > 0 ? 1 : 2];
    } else {
      EXPECT_NEAR(way.distances[i], way.distances[i] > kTravel / 2 ? kTravel : 0.0, 1e-9);
      ++cases[way.distances[i] > kTravel / 2 ? 0 : 3];
    }
  }
  EXPECT_GT(
      chi_square_p_value(
          cases, {kDrivenSteps * (1 - kSlip) * (1 - kSlip), kDrivenSteps * kSlip * (1 - kSlip),
                  kDrivenSteps * kSlip * (1 - kSlip), kDrivenSteps * kSlip * kSlip}),
      kUnlikely);
  EXPECT_NEAR(way.odometry.x, kDrivenSteps * kTravel, 1e-6) << "the encoders count on";
}

/// Binomial coefficients from the left: the share of `k` of `n`.
double binomial_share(int n, int k, double p) {
  return std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) +
                  k * std::log(p) + (n - k) * std::log(1 - p));
}

TEST(EncoderErrors, TicksAreMissedOneByOne) {
  constexpr double kMiss = 0.1;
  constexpr int kTicks = 20;
  DriveError error;
  error.encoder_miss = kMiss;
  for (const double direction : {1.0, -1.0}) {
    const Way way = drive(model_with(error, kTicks), {direction * kSpeed, 0.0});
    std::vector<double> counts(6);  // missed in a step; the last for five and more
    double sum = 0;
    for (const std::int64_t ticks : way.ticks) {
      const auto missed = kTicks - ticks * static_cast<std::int64_t>(direction);
      ASSERT_GE(missed, -1);  // where rounding moves a tick to the next step
      ++counts[static_cast<std::size_t>(std::clamp<std::int64_t>(missed, 0, 5))];
      sum += static_cast<double>(ticks);
    }
    std::vector<double> expected(6);
    for (int k = 0; k <= kTicks; ++k) {
      expected[static_cast<std::size_t>(std::min(k, 5))] +=
          kDrivenSteps * binomial_share(kTicks, k, kMiss);
    }
    EXPECT_GT(chi_square_p_value(counts, expected), kUnlikely);
    const double share = direction * sum / (kDrivenSteps * double{kTicks});
    EXPECT_NEAR(share, 1 - kMiss,
                4 * std::sqrt(kMiss * (1 - kMiss) / (kDrivenSteps * double{kTicks})));
    EXPECT_NEAR(way.odometry.x, direction * share * kDrivenSteps * kTravel, 0.5)
        << "odometry sees what was counted: 3 m less, and a heading that drifts";
  }
}

TEST(EncoderErrors, ManyTicksAStepAreMissedByTheSameMeanAndDeviation) {
  constexpr double kTicks = 2000;
  constexpr double kMiss = 0.05;
  DriveError error;
  error.encoder_miss = kMiss;
  const Way way = drive(model_with(error, kTicks), {kSpeed, 0.0});
  const std::vector<double> ticks(way.ticks.begin(), way.ticks.end());
  const Moments moments = moments_of(ticks);
  const double sigma = std::sqrt(kTicks * kMiss * (1 - kMiss));
  EXPECT_NEAR(moments.mean, kTicks * (1 - kMiss), 4 * sigma / std::sqrt(double{kDrivenSteps}));
  EXPECT_NEAR(moments.deviation, sigma, 4 * sigma / std::sqrt(2.0 * kDrivenSteps));
}

TEST(EncoderErrors, QuantisedOdometryIsOffByLessThanATick) {
  DriveError error;
  error.encoder_quantised = true;
  const RobotModel model = model_with(error, 0.3);  // coarse: a tick every third step
  const Way way = drive(model, {kSpeed, 0.0});
  const double tick = kTravel / 0.3;
  EXPECT_NEAR(way.odometry.x, kDrivenSteps * kTravel, tick);
  EXPECT_NEAR(std::remainder(way.odometry.x, tick), 0.0, 1e-6) << "whole ticks only";
}

}  // namespace
}  // namespace eyebridge::robot
