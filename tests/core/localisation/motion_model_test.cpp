#include "eyebridge/localisation/motion_model.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>

#include <gtest/gtest.h>

#include "eyebridge/robot/simulation.hpp"
#include "statistics.hpp"

namespace eyebridge::localisation {
namespace {

using eyebridge::testing::expect_normal;
using eyebridge::testing::moments_of;

constexpr int kDraws = 20000;

void expect_pose(const Pose& pose, const Pose& expected) {
  EXPECT_NEAR(pose.x, expected.x, 1e-12);
  EXPECT_NEAR(pose.y, expected.y, 1e-12);
  EXPECT_NEAR(wrap_angle(pose.theta - expected.theta), 0, 1e-12);
}

TEST(OdometryStep, LeadsFromTheFirstPoseToTheSecond) {
  Random random(1);
  const auto any = [&] {
    return Pose{random.uniform() - 0.5, random.uniform() - 0.5, 6 * (random.uniform() - 0.5)};
  };
  for (int i = 0; i < 1000; ++i) {
    const Pose before = any();
    const Pose after = any();
    const OdometryStep step = OdometryStep::between(before, after);
    EXPECT_LE(std::abs(step.first_turn), kPi / 2);
    expect_pose(step.applied_to(before), after);
  }
}

TEST(OdometryStep, BackwardsIsNoTurn) {
  const OdometryStep step =
      OdometryStep::between({1, 1, 0.5}, transform({1, 1, 0.5}, {-0.2, 0, 0}));
  EXPECT_NEAR(step.first_turn, 0, 1e-12);
  EXPECT_NEAR(step.travel, -0.2, 1e-12);
  EXPECT_NEAR(step.second_turn, 0, 1e-12);
  const OdometryStep turn = OdometryStep::between({1, 1, 0.5}, {1 + 1e-9, 1, 0.8});
  EXPECT_EQ(turn.first_turn, 0);
  EXPECT_NEAR(turn.second_turn, 0.3, 1e-12);
}

TEST(OdometryMotion, ScattersEachPartByItsVariance) {
  OdometryNoise noise{0.04, 0.09, 0.01, 0.0025, 0.003, 0.002};
  const OdometryStep step{0.5, 0.8, -0.3};
  Random random(2);
  std::vector<double> turns;
  std::vector<double> travels;
  std::vector<double> headings;
  for (int i = 0; i < kDraws; ++i) {
    const Pose pose = sample_motion(Pose{}, step, noise, random);
    turns.push_back(std::atan2(pose.y, pose.x));
    travels.push_back(std::hypot(pose.x, pose.y));
    headings.push_back(pose.theta);
  }
  const double first = 0.04 * 0.25 + 0.09 * 0.64 + 4e-6;
  const double second = 0.04 * 0.09 + 0.09 * 0.64 + 4e-6;
  expect_normal(turns, 0.5, std::sqrt(first));
  expect_normal(travels, 0.8, std::sqrt(0.01 * 0.64 + 0.0025 * (0.25 + 0.09) + 9e-6));
  expect_normal(headings, 0.2, std::sqrt(first + second));
}

TEST(OdometryMotion, MovesParticlesAsItMovesPoses) {
  const OdometryNoise noise;
  const OdometryStep step{0.5, 0.8, -0.3};
  Particles particles;
  for (int i = 0; i < 5; ++i) particles.add({i * 0.1, 1, i * 0.2}, 0.2);
  Random one(3);
  Random other(3);
  sample_motion(particles, step, noise, one);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(particles.pose(static_cast<std::size_t>(i)),
              sample_motion({i * 0.1, 1, i * 0.2}, step, noise, other));
  }
}

TEST(VelocityMotion, FollowsTheArcWithoutNoise) {
  Random random(4);
  const VelocityNoise none{0, 0, 0, 0, 0, 0};
  // A quarter of a circle of 0.5 m.
  expect_pose(sample_motion({1, 1, 0}, {0.5, 1.0}, kPi / 2, none, random), {1.5, 1.5, kPi / 2});
  expect_pose(sample_motion({1, 1, kPi / 2}, {0.5, 0.0}, 2.0, none, random), {1, 2, kPi / 2});
}

TEST(VelocityMotion, ScattersSpeedsByTheirVariance) {
  const VelocityNoise noise{0.04, 0.01, 0.02, 0.03, 0.001, 0.002};
  const Twist twist{0.4, 0.5};
  Random random(5);
  std::vector<double> headings;
  std::vector<double> chords;
  for (int i = 0; i < kDraws; ++i) {
    const Pose pose = sample_motion(Pose{}, twist, 1.0, noise, random);
    headings.push_back(pose.theta);
    // The chord's direction is half the turn of the arc, without the turn at the end.
    const double arc = 2 * std::atan2(pose.y, pose.x);
    chords.push_back(std::hypot(pose.x, pose.y) * (arc / 2) / std::sin(arc / 2));
  }
  expect_normal(headings, 0.5, std::sqrt(0.02 * 0.16 + 0.03 * 0.25 + 0.001 * 0.16 + 0.002 * 0.25));
  expect_normal(chords, 0.4, std::sqrt(0.04 * 0.16 + 0.01 * 0.25));
}

/// Spread of (travel, heading) errors of simulated robots that drive `distance` ahead.
struct Spread {
  double travel;
  double heading;
};

Spread spread_over(const robot::DriveError& error, double distance) {
  robot::RobotModel model;
  model.drive_error = error;
  std::vector<double> travels;
  std::vector<double> headings;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    world::WorldModel floor;
    floor.width = floor.height = 4;
    robot::SimulationSettings settings;
    settings.seed = seed;
    robot::Simulation sim(std::make_shared<const world::WorldModel>(floor), settings);
    const auto robot = sim.add_robot(model, {1, 2, 0});
    sim.set_speed(robot, {0.3, 0});
    while (sim.odometry(robot).x < distance) sim.step();
    const Pose away = relative_to(relative_to({}, {1, 2, 0}), sim.pose(robot));
    travels.push_back(away.x - sim.odometry(robot).x);
    headings.push_back(wrap_angle(away.theta - sim.odometry(robot).theta));
  }
  return {moments_of(travels).deviation, moments_of(headings).deviation};
}

TEST(OdometryNoise, IsWhatRobotsWithSlippingWheelsShow) {
  robot::DriveError error;
  error.slip = 0.01;
  constexpr double kTravel = 0.3;
  const Spread seen = spread_over(error, kTravel);
  const OdometryNoise noise = odometry_noise(error, {}, kTravel, 0.003);
  const double heading = kTravel * std::sqrt(2 * noise.turn_by_travel);
  // 300 robots: the deviation of a deviation is 4 %.
  EXPECT_NEAR(seen.heading / heading, 1.0, 0.17);
}

TEST(OdometryNoise, IsWhatRobotsWithUnsteadyTravelShow) {
  robot::DriveError error;
  error.linear_sigma = 0.2;
  constexpr double kTravel = 0.3;
  const Spread seen = spread_over(error, kTravel);
  const OdometryNoise noise = odometry_noise(error, {}, kTravel, 0.003);
  EXPECT_NEAR(seen.travel / (kTravel * std::sqrt(noise.travel_by_travel)), 1.0, 0.17);
}

TEST(OdometryNoise, CountsUnequalWheelsInFullAndWholeTicks) {
  robot::DriveError error;
  error.left_scale = -0.01;
  error.right_scale = 0.01;
  robot::DriveModel drive;
  drive.wheel_base = 0.1;
  const OdometryNoise noise = odometry_noise(error, drive, 1.0, 0.01);
  EXPECT_NEAR(std::sqrt(2 * noise.turn_by_travel), 0.2, 1e-12);  // 2 % of a metre over 0.1 m
  EXPECT_EQ(noise.least_turn_sigma, 0);
  error = {};
  error.encoder_quantised = true;
  EXPECT_GT(odometry_noise(error, drive, 1.0, 0.01).least_turn_sigma, 0);
  EXPECT_THROW((void)odometry_noise(error, drive, 0.0, 0.01), std::invalid_argument);
  EXPECT_THROW((void)velocity_noise(error, drive, 1.0, -1.0), std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::localisation
