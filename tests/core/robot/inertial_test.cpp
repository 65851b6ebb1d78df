// Gyroscope and accelerometer: closed forms of what they read, and their errors.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "rig.hpp"
#include "statistics.hpp"

namespace eyebridge::robot {
namespace {

using namespace eyebridge::testing;

TEST(Gyroscope, ReadsTheRateOfTurn) {
  Rig rig;
  EXPECT_EQ(rig.sim.read_gyroscope(rig.robot), 0.0);
  for (const double rate : {1.0, -0.4, 0.0}) {
    rig.sim.set_speed(rig.robot, {0.1, rate});
    rig.steps(100);
    EXPECT_NEAR(rig.sim.read_gyroscope(rig.robot), rate, 1e-12);
  }
}

TEST(Gyroscope, SumsUpToTheHeading) {
  Rig rig;
  double sum = 0.0;
  for (int i = 0; i < 400; ++i) {
    if (i % 40 == 0) rig.sim.set_speed(rig.robot, {0.05, i % 80 == 0 ? 1.5 : -0.6});
    rig.sim.step();
    sum += rig.sim.read_gyroscope(rig.robot) * 0.01;
  }
  EXPECT_NEAR(wrap_angle(sum), rig.sim.pose(rig.robot).theta, 1e-9);
}

TEST(Gyroscope, ErrorsAreNormallyDistributedAboutTheRate) {
  RobotModel model;
  model.gyroscope_error.bias = 0.02;
  model.gyroscope_error.sigma = 0.01;
  model.gyroscope_error.sigma_relative = 0.05;
  Rig rig(model);
  rig.sim.set_speed(rig.robot, {0.0, 1.0});
  rig.steps(100);
  std::vector<double> sample(20000);
  for (double& rate : sample) rate = rig.sim.read_gyroscope(rig.robot);
  expect_normal(sample, 1.02, 0.06);
}

/// Biases of so many gyroscopes after 25 s; with `looks`, they are read all the time.
std::vector<double> strayed(bool looks) {
  RobotModel model;
  model.gyroscope_error.bias = 0.1;
  model.gyroscope_error.drift = 0.02;
  std::vector<double> sample(1500);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    SimulationSettings settings;
    settings.step = 0.5;
    settings.seed = i + 1;
    Rig rig(model, {2, 2, 0}, settings);
    for (int step = 0; step < 50; ++step) {
      rig.sim.step();
      if (looks) static_cast<void>(rig.sim.read_gyroscope(rig.robot));
    }
    sample[i] = rig.sim.read_gyroscope(rig.robot);
  }
  return sample;
}

TEST(Gyroscope, BiasStraysWithTheRootOfTimeHoweverOftenItIsAsked) {
  expect_normal(strayed(false), 0.1, 0.02 * 5);
  expect_normal(strayed(true), 0.1, 0.02 * 5);
}

TEST(Gyroscope, BiasDoesNotJumpBetweenReadingsOfOneMoment) {
  RobotModel model;
  model.gyroscope_error.drift = 0.02;
  Rig rig(model);
  rig.steps(100);
  const double first = rig.sim.read_gyroscope(rig.robot);
  EXPECT_NE(first, 0.0);
  EXPECT_EQ(rig.sim.read_gyroscope(rig.robot), first);
  rig.sim.step();
  EXPECT_NE(rig.sim.read_gyroscope(rig.robot), first);
}

TEST(Gyroscope, OfARobotThatComesLaterStraysFromThenOn) {
  RobotModel model;
  model.gyroscope_error.drift = 0.02;
  Rig rig;
  rig.steps(1000);
  const RobotIndex late = rig.sim.add_robot(model, {1, 1, 0});
  EXPECT_EQ(rig.sim.read_gyroscope(late), 0.0);
}

TEST(Gyroscope, DriftThatIsSwitchedOnCountsFromThenOn) {
  Rig rig;
  rig.steps(1000);
  RobotModel like;
  like.gyroscope_error.drift = 0.02;
  rig.sim.set_errors(rig.robot, like);
  EXPECT_EQ(rig.sim.read_gyroscope(rig.robot), 0.0);
  rig.sim.step();
  EXPECT_NE(rig.sim.read_gyroscope(rig.robot), 0.0);
}

TEST(Accelerometer, ReadsTheRampWhileItLastsAndNothingAfter) {
  Rig rig;
  EXPECT_EQ(rig.sim.read_accelerometer(rig.robot), (Vec2{}));
  rig.sim.set_speed(rig.robot, {0.4, 0.0});
  for (int i = 0; i < 40; ++i) {  // 1 m/s^2
    rig.sim.step();
    ASSERT_NEAR(rig.sim.read_accelerometer(rig.robot).x, 1.0, 1e-9) << i;
  }
  rig.sim.step();
  EXPECT_NEAR(rig.sim.read_accelerometer(rig.robot).x, 0.0, 1e-9);
  rig.steps(50);
  EXPECT_EQ(rig.sim.read_accelerometer(rig.robot), (Vec2{}));
  rig.sim.set_speed(rig.robot, {0.0, 0.0});
  rig.sim.step();
  EXPECT_NEAR(rig.sim.read_accelerometer(rig.robot).x, -1.0, 1e-9);
  rig.steps(100);
  EXPECT_EQ(rig.sim.read_accelerometer(rig.robot), (Vec2{}));
}

TEST(Accelerometer, ReadsWhatHoldsTheRobotOnItsCurve) {
  for (const double turn : {0.8, -0.8}) {
    Rig rig;
    rig.sim.set_speed(rig.robot, {0.3, turn});
    rig.steps(150);
    const Vec2 felt = rig.sim.read_accelerometer(rig.robot);
    EXPECT_NEAR(felt.x, 0.0, 1e-9);
    EXPECT_NEAR(felt.y, 0.3 * turn, 1e-9) << "towards the centre of the circle";
  }
}

TEST(Accelerometer, ReadsWhatHoldsARobotThatDrivesSidewaysOnItsCurve) {
  RobotModel model;
  model.drive.kind = DriveKind::Omni;
  model.drive.axle_distance = 0.16;
  Rig rig(model);
  rig.sim.set_twist(rig.robot, {0.0, 0.2, 0.0});
  rig.sim.step();
  EXPECT_GT(rig.sim.read_accelerometer(rig.robot).y, 0.0) << "it speeds up to its left";
  rig.sim.set_twist(rig.robot, {0.0, 0.2, 0.5});
  rig.steps(150);
  const HolonomicTwist body = rig.sim.body_twist(rig.robot);
  ASSERT_NEAR(body.lateral, 0.2, 1e-9);
  const Vec2 felt = rig.sim.read_accelerometer(rig.robot);
  EXPECT_NEAR(felt.x, -0.2 * 0.5, 1e-9) << "the circle's centre is behind it";
  EXPECT_NEAR(felt.y, 0.0, 1e-9);
}

TEST(Accelerometer, FeelsACollisionForOneStep) {
  Rig rig({}, {3.8, 2, 0});
  rig.sim.set_speed(rig.robot, {0.4, 0.0});
  double before = 0.0;
  double felt = 0.0;
  for (int i = 0; i < 200 && felt > -1.5; ++i) {
    before = rig.sim.twist(rig.robot).linear;
    rig.sim.step();
    felt = std::min(felt, rig.sim.read_accelerometer(rig.robot).x);
  }
  EXPECT_LT(felt, -1.5);
  EXPECT_NEAR(felt, (rig.sim.twist(rig.robot).linear - before) / 0.01, 1e-9);
  rig.steps(5);
  EXPECT_EQ(rig.sim.read_accelerometer(rig.robot), (Vec2{})) << "pressed against the wall";
}

TEST(Accelerometer, DoesNotFeelAPersonsHand) {
  Rig rig;
  rig.sim.set_speed(rig.robot, {0.4, 0.0});
  rig.steps(20);
  rig.sim.set_pose(rig.robot, {1, 1, 0});
  EXPECT_EQ(rig.sim.read_accelerometer(rig.robot), (Vec2{}));
}

TEST(Accelerometer, ReadsTheSameHoweverOftenItIsAsked) {
  // Robots that go on steadily are stepped by a shorter way, until somebody asks.
  Rig often;
  Rig seldom;
  double sum = 0.0;
  for (int i = 0; i < 600; ++i) {
    for (Rig* rig : {&often, &seldom}) {
      if (i % 97 == 0) rig->sim.set_speed(rig->robot, {i % 2 == 0 ? 0.3 : -0.2, 0.1 * (i % 5)});
      rig->sim.step();
    }
    const Vec2 felt = often.sim.read_accelerometer(often.robot);
    sum += felt.x * 0.01;
    ASSERT_NEAR(sum, often.sim.twist(often.robot).linear, 1e-9) << "the speed is its sum";
    if (i % 7 == 0) {
      ASSERT_EQ(seldom.sim.read_accelerometer(seldom.robot), felt) << i;
    }
  }
}

TEST(Accelerometer, ErrorsOfTheAxesAreNormallyDistributedAndIndependent) {
  RobotModel model;
  model.accelerometer_error.bias = 0.1;
  model.accelerometer_error.sigma = 0.05;
  Rig rig(model);
  std::vector<double> x;
  std::vector<double> y;
  double covariance = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const Vec2 felt = rig.sim.read_accelerometer(rig.robot);
    x.push_back(felt.x);
    y.push_back(felt.y);
    covariance += (felt.x - 0.1) * (felt.y - 0.1) / 20000;
  }
  expect_normal(x, 0.1, 0.05);
  expect_normal(y, 0.1, 0.05);
  EXPECT_NEAR(covariance / (0.05 * 0.05), 0.0, 4 / std::sqrt(20000.0));
}

}  // namespace
}  // namespace eyebridge::robot
