#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/robot/tally.hpp"
#include "rig.hpp"

// What a robot does that is in contact: the law is in world::ContactLaw.

namespace eyebridge::robot {
namespace {

constexpr double kContactSpeed = 0.2;  // metres per second
constexpr double kBodyRadius = 0.093;  // of an S4, metres
constexpr double kAtWall = kBodyRadius + 1e-6;

/// An S4 in a long room whose wall y = 0 it touches, its front `degrees` towards the wall.
Rig grazing(double degrees, RobotModel model = {}, const SimulationSettings& settings = {}) {
  Rig rig(model, {2.0, kAtWall, -deg_to_rad(degrees)}, settings);
  return rig;
}

/// Metres per second along the wall, once the robot has its speed.
double speed_along(Rig& rig) {
  rig.sim.set_speed(rig.robot, {kContactSpeed, 0.0});
  rig.steps(100);
  const double before = rig.sim.pose(rig.robot).x;
  rig.steps(200);
  return (rig.sim.pose(rig.robot).x - before) / 2.0;
}

TEST(Contact, SpeedAlongTheWallIsThatOfTheLaw) {
  for (const double friction : {0.0, 0.3, 1.0}) {
    for (int degrees = 0; degrees <= 90; ++degrees) {
      RobotModel model;
      model.contact_friction = friction;
      Rig rig = grazing(degrees, model);
      const double a = deg_to_rad(degrees);
      const double law = kContactSpeed * std::max(0.0, std::cos(a) - friction * std::sin(a));
      EXPECT_NEAR(speed_along(rig), law, 0.01 * law + 1e-6) << degrees << " deg, " << friction;
      EXPECT_GE(rig.sim.pose(rig.robot).y, kBodyRadius) << "within the wall";
    }
  }
}

TEST(Contact, TheSameLawHoldsBackwards) {
  Rig rig = grazing(150);
  rig.sim.set_speed(rig.robot, {-kContactSpeed, 0.0});
  rig.steps(300);
  EXPECT_GT(rig.sim.pose(rig.robot).x, 2.3) << "30 degrees to a wall behind it: it leaves";
  Rig into = grazing(-30);
  into.sim.set_speed(into.robot, {-kContactSpeed, 0.0});
  into.steps(100);
  const double before = into.sim.pose(into.robot).x;
  into.steps(100);
  const double law = kContactSpeed * (std::cos(deg_to_rad(30)) - 0.3 * std::sin(deg_to_rad(30)));
  EXPECT_NEAR(before - into.sim.pose(into.robot).x, law, 0.01 * law);
}

TEST(Contact, WheelsTurnAsFarAsTheRobotComesForward) {
  Rig rig = grazing(20);
  rig.sim.set_speed(rig.robot, {kContactSpeed, 0.0});
  rig.steps(300);
  const double way = rig.sim.pose(rig.robot).x - 2.0;
  const double forward = way * std::cos(deg_to_rad(20));
  EXPECT_NEAR(rig.sim.odometry(rig.robot).x, forward, 1e-3);
  const double ticks = forward / (kPi * 0.054) * 1100;
  EXPECT_NEAR(static_cast<double>(rig.sim.encoder_ticks(rig.robot, 0)), ticks, 10.0);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallNone) << "it goes on";
}

TEST(Contact, AHitWithinTheConeOfFrictionStalls) {
  for (const double degrees : {74.0, 85.0, 90.0}) {
    Rig rig = grazing(degrees);
    rig.sim.set_speed(rig.robot, {kContactSpeed, 0.0});
    rig.steps(100);
    EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth) << degrees;
    EXPECT_NEAR(rig.sim.pose(rig.robot).x, 2.0, 1e-5);
    EXPECT_EQ(rig.sim.encoder_ticks(rig.robot, 0), 0);
  }
}

TEST(Contact, TheHeadingTurnsInContactAndTheRobotLeaves) {
  for (const bool slides : {true, false}) {
    SimulationSettings settings;
    settings.slides = slides;
    Rig rig = grazing(90, {}, settings);
    rig.sim.set_speed(rig.robot, {0.1, deg_to_rad(30)});
    rig.steps(200);
    // The ramp of 10 rad/s^2 takes 5 steps, of which half is lost.
    EXPECT_NEAR(rad_to_deg(rig.sim.pose(rig.robot).theta), -90 + 60, 1.0) << slides;
    EXPECT_NEAR(rig.sim.odometry(rig.robot).theta, deg_to_rad(60), 0.02) << "as far as it turned";
    rig.steps(400);
    EXPECT_GT(rig.sim.pose(rig.robot).y, 0.2) << "it has left the wall";
  }
}

TEST(Contact, StopIsTheRobotThatStands) {
  SimulationSettings settings;
  settings.slides = false;
  Rig rig = grazing(3, {}, settings);
  rig.sim.set_speed(rig.robot, {kContactSpeed, 0.0});
  rig.steps(300);
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, 2.0, 1e-4);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth);
}

TEST(Contact, MotorsSlideAsTheControllerDoes) {
  for (const double lag : {0.0, 0.1}) {
    RobotModel model;
    model.drive.motor_time_constant = lag;
    Rig rig = grazing(10, model);
    const double ticks = kContactSpeed / (kPi * 0.054) * 1100;
    rig.sim.set_motor_speed(rig.robot, 0, ticks);
    rig.sim.set_motor_speed(rig.robot, 1, ticks);
    rig.steps(300);
    EXPECT_GT(rig.sim.pose(rig.robot).x, 2.4) << lag;
    EXPECT_EQ(rig.sim.stalled(rig.robot), kStallNone);
    EXPECT_NEAR(rad_to_deg(rig.sim.pose(rig.robot).theta), -10, 1e-6);
  }
}

TEST(Contact, ARobotSlidesRoundAnotherOne) {
  Rig rig({}, {1.0, 2.0, 0.0});
  const RobotIndex other = rig.sim.add_robot({}, {1.5, 2.1, 0.0});
  rig.sim.set_speed(rig.robot, {kContactSpeed, 0.0});
  double before = rig.sim.pose(rig.robot).x;
  for (int i = 0; i < 1000; ++i) {
    rig.steps(1);
    const Pose at = rig.sim.pose(rig.robot);
    const Pose beside = rig.sim.pose(other);
    ASSERT_GE(at.x, before) << "no step back";
    ASSERT_LE(at.x - before, kContactSpeed * 0.01 + 1e-12) << "no faster than it drives";
    ASSERT_GE(norm(Vec2{at.x - beside.x, at.y - beside.y}), 2 * kBodyRadius);
    before = at.x;
  }
  EXPECT_GT(before, 1.7) << "it came past";
  EXPECT_EQ(rig.sim.pose(other), (Pose{1.5, 2.1, 0.0})) << "robots do not give way";
}

TEST(Contact, CornersHoldWithoutJitter) {
  // Into the corner at the origin, at every angle that leads there.
  for (int degrees = 187; degrees < 264; ++degrees) {
    RobotModel slippery;
    slippery.contact_friction = 0.0;
    Rig rig(slippery, {0.3, 0.3, deg_to_rad(degrees)});
    rig.sim.set_speed(rig.robot, {kContactSpeed, 0.0});
    rig.steps(1500);
    const Pose stands = rig.sim.pose(rig.robot);
    for (int i = 0; i < 100; ++i) {
      rig.steps(1);
      const Pose now = rig.sim.pose(rig.robot);
      ASSERT_LE(norm(Vec2{now.x - stands.x, now.y - stands.y}), 1e-6) << degrees;
      ASSERT_EQ(now.theta, stands.theta);
    }
    EXPECT_GE(std::min(stands.x, stands.y), kBodyRadius);
    EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth) << degrees;
  }
}

TEST(Contact, ABendInAWallLeadsOn) {
  // A wall that turns towards the robot by 10 degrees: it goes on along the second part.
  auto model = std::make_shared<world::WorldModel>(*room(4.0, 4.0));
  world::Wall bend;
  bend.a = {2.0, 0.0};
  bend.b = {2.0 + 1.5 * std::cos(deg_to_rad(10)), 1.5 * std::sin(deg_to_rad(10))};
  model->walls.push_back(bend);
  Simulation sim(model, {});
  const RobotIndex robot = sim.add_robot({}, {1.5, kAtWall, -deg_to_rad(5)});
  sim.set_speed(robot, {kContactSpeed, 0.0});
  for (int i = 0; i < 800; ++i) sim.step();
  EXPECT_GT(sim.pose(robot).x, 2.8);
}

TEST(Contact, NobodyEverGetsFasterOrIntoAnything) {
  // Many robots that push against each other and the walls, all kinds of drives.
  Simulation sim(room(1.2, 1.2), {});
  Random random(7);
  constexpr std::array kinds{DriveKind::Differential, DriveKind::Omni, DriveKind::Ackermann,
                             DriveKind::Swedish, DriveKind::Synchro};
  std::vector<RobotIndex> robots;
  for (int i = 0; i < 16; ++i) {
    RobotModel model;
    model.drive.kind = kinds[static_cast<std::size_t>(i) % kinds.size()];
    robots.push_back(sim.add_robot(
        model, {0.15 + 0.3 * (i % 4), 0.15 + 0.3 * (i / 4), random.uniform() * 2 * kPi}));
  }
  for (int step = 0; step < 3000; ++step) {
    if (step % 100 == 0) {
      for (const RobotIndex robot : robots) {
        sim.set_speed(robot, {0.4 * random.uniform() - 0.1, 2 * random.uniform() - 1});
      }
    }
    std::vector<Pose> before;
    for (const RobotIndex robot : robots) before.push_back(sim.pose(robot));
    sim.step();
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const Pose now = sim.pose(robots[i]);
      const double way = norm(Vec2{now.x - before[i].x, now.y - before[i].y});
      ASSERT_LE(way, 0.3 * 0.01 + 1e-8) << i;
      ASSERT_GE(std::min({now.x, now.y, 1.2 - now.x, 1.2 - now.y}), kBodyRadius) << i;
      for (std::size_t j = 0; j < i; ++j) {
        const Pose other = sim.pose(robots[j]);
        ASSERT_GE(norm(Vec2{now.x - other.x, now.y - other.y}), 2 * kBodyRadius) << i << " " << j;
      }
    }
  }
}

TEST(Contact, HowLongARobotStoodInVainIsCounted) {
  Rig rig = grazing(90);
  Tally tally;
  const auto steps = [&](int count) {
    for (int i = 0; i < count; ++i) {
      rig.sim.step();
      tally.add_step(rig.sim);
    }
  };
  steps(300);
  EXPECT_EQ(tally.longest_stuck(), 0.0) << "nobody told it to move";
  rig.sim.set_speed(rig.robot, {kContactSpeed, 0.0});
  steps(300);
  EXPECT_NEAR(tally.longest_stuck(), 3.0, 0.05);
  rig.sim.set_speed(rig.robot, {0.0, 1.0});
  steps(100);
  rig.sim.set_motor_speed(rig.robot, 0, 0.0);
  steps(500);
  EXPECT_NEAR(tally.longest_stuck(), 3.0, 0.05) << "the longest time counts";
}

TEST(Contact, OmniWheelsSlideAndTurn) {
  RobotModel model;
  model.drive.kind = DriveKind::Omni;
  Rig rig({model}, {2.0, kAtWall, 0.0});
  // Sideways into the wall and forward: 45 degrees of incidence.
  rig.sim.set_twist(rig.robot, {0.1, -0.1, 0.0});
  rig.steps(100);
  const double before = rig.sim.pose(rig.robot).x;
  rig.steps(100);
  EXPECT_NEAR(rig.sim.pose(rig.robot).x - before, 0.7 * 0.1, 0.001);
  rig.sim.set_twist(rig.robot, {0.0, -0.1, 0.5});
  rig.steps(100);
  EXPECT_GT(rig.sim.pose(rig.robot).theta, 0.4);
}

TEST(Contact, ACarTurnsOnlyAsItRolls) {
  RobotModel model;
  model.drive.kind = DriveKind::Ackermann;
  Rig rig = grazing(90, model);
  rig.sim.set_speed(rig.robot, {0.1, 0.5});
  rig.steps(200);
  EXPECT_NEAR(rad_to_deg(rig.sim.pose(rig.robot).theta), -90, 1e-3);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth);
}

}  // namespace
}  // namespace eyebridge::robot
