// How far a person is with a movement, and what they are told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"
#include "hand/movement.hpp"

namespace eyebridge::hal {
namespace {

using Kind = Instruction::Kind;

/// A robot that is put here and there, and its movement is told.
struct Walk {
  Movement movement;
  Pose here{1.0, 1.0, 0.0};

  void start(const DriveGoal& goal) { movement.start(goal, here); }
  void to(const Pose& there) {
    movement.moved(here, there);
    here = there;
  }
  /// Along the heading, then turns.
  void by(double distance, double turn_deg = 0.0) {
    const Pose ahead = transform(here, {distance, 0.0, 0.0});
    to(ahead);
    to({here.x, here.y, wrap_angle(here.theta + deg_to_rad(turn_deg))});
  }
};

TEST(HandMovement, AStraightIsMadeTwentyMillimetresBeforeItsEnd) {
  Walk walk;
  walk.start({0.3, 0.0, 0.2});
  EXPECT_TRUE(walk.movement.driving());
  EXPECT_NEAR(walk.movement.remaining(), 0.3, 1e-12);
  walk.by(0.279);
  EXPECT_TRUE(walk.movement.driving());
  EXPECT_NEAR(walk.movement.remaining(), 0.021, 1e-12);
  walk.by(0.002);
  EXPECT_FALSE(walk.movement.driving());
  EXPECT_EQ(walk.movement.remaining(), 0.0);
}

TEST(HandMovement, PassingTheGoalCounts) {
  Walk walk;
  walk.start({-0.3, 0.0, 0.2});
  walk.by(-1.0);
  EXPECT_FALSE(walk.movement.driving());
  walk.start({0.0, deg_to_rad(90), 1.0});
  walk.by(0.0, 130.0);
  EXPECT_FALSE(walk.movement.driving());
}

TEST(HandMovement, TheWrongWayIsNoProgress) {
  Walk walk;
  walk.start({0.3, 0.0, 0.2});
  walk.by(-0.3);
  EXPECT_TRUE(walk.movement.driving());
  EXPECT_NEAR(walk.movement.remaining(), 0.6, 1e-12);
  walk.start({0.0, deg_to_rad(-90), 1.0});
  walk.by(0.0, 90.0);
  EXPECT_TRUE(walk.movement.driving());
}

TEST(HandMovement, AStepToTheSideIsNoWay) {
  Walk walk;
  walk.start({0.3, 0.0, 0.2});
  walk.to({1.0, 1.5, 0.0});
  EXPECT_NEAR(walk.movement.remaining(), 0.3, 1e-12);
}

TEST(HandMovement, ATurnIsMadeThreeDegreesBeforeItsEndAndMayGoRoundMoreThanOnce) {
  Walk walk;
  walk.start({0.0, deg_to_rad(720), 1.0});
  for (int i = 0; i < 71; ++i) walk.by(0.0, 10.0);
  EXPECT_TRUE(walk.movement.driving());
  EXPECT_NEAR(walk.movement.instruction().angle, deg_to_rad(10), 1e-9);
  walk.by(0.0, 7.5);
  EXPECT_FALSE(walk.movement.driving());
}

TEST(HandMovement, ACurveIsMadeWhenItsWayAndItsTurnAre) {
  Walk walk;
  walk.start({0.3, deg_to_rad(90), 0.2});
  for (int i = 0; i < 30; ++i) walk.by(0.0095, 0.0);
  EXPECT_TRUE(walk.movement.driving()) << "not turned yet";
  EXPECT_NEAR(walk.movement.remaining(), 0.015, 1e-9);
  walk.by(0.0, 88.0);
  EXPECT_FALSE(walk.movement.driving());
}

TEST(HandMovement, WhatOneMovementIsShortOfIsMadeUpForByThoseThatFollow) {
  Walk walk;
  // Five in a row, each left as early as it counts.
  for (int i = 0; i < 5; ++i) {
    walk.start({0.3, 0.0, 0.2});
    while (walk.movement.driving()) walk.by(0.001);
  }
  EXPECT_NEAR(walk.here.x, 1.0 + 5 * 0.3 - kHandDistance, 0.0015);
  for (int i = 0; i < 4; ++i) {
    walk.start({0.0, deg_to_rad(90), 1.0});
    while (walk.movement.driving()) walk.by(0.0, 0.1);
  }
  EXPECT_NEAR(walk.here.theta, -kHandAngle, deg_to_rad(0.15));
}

TEST(HandMovement, WhatIsMissingToTheSideIsMadeUpForAfterATurn) {
  Walk walk;
  walk.start({0.3, 0.0, 0.2});
  walk.to({1.3, 1.05, 0.0});  // there, but 50 mm to the left
  ASSERT_FALSE(walk.movement.driving());
  walk.start({0.0, deg_to_rad(90), 1.0});
  walk.by(0.0, 90.0);
  walk.start({0.3, 0.0, 0.2});
  EXPECT_NEAR(walk.movement.remaining(), 0.25, 1e-9);
}

TEST(HandMovement, AGoalBeginsHereAfterWhatHasNoEndAndFarFromWhereItShouldBegin) {
  Walk walk;
  walk.start({0.3, 0.0, 0.2});
  walk.by(0.2);
  walk.start({0.3, 0.0, 0.2});  // broken off
  EXPECT_NEAR(walk.movement.remaining(), 0.3, 1e-12);
  walk.by(0.29);
  walk.movement.set_speed({0.1, 0.0});
  walk.start({0.3, 0.0, 0.2});
  EXPECT_NEAR(walk.movement.remaining(), 0.3, 1e-12);
  walk.by(0.3 + Movement::kFarAway + 0.01);
  walk.start({0.3, 0.0, 0.2});
  EXPECT_NEAR(walk.movement.remaining(), 0.3, 1e-12);
}

TEST(HandMovement, AGoalWithoutLengthOrSpeedStops) {
  Walk walk;
  for (const DriveGoal& goal : {DriveGoal{0.0, 0.0, 0.2}, DriveGoal{0.3, 0.0, 0.0}}) {
    walk.movement.set_speed({0.1, 0.0});
    walk.start(goal);
    EXPECT_FALSE(walk.movement.driving());
    EXPECT_EQ(walk.movement.instruction().kind, Kind::Stand);
  }
}

TEST(HandMovement, NoiseOfARobotThatStandsDoesNotAddUp) {
  Walk walk;
  walk.start({0.3, 0.0, 0.2});
  Random random(7);
  const Pose truth = walk.here;
  for (int i = 0; i < 30 * 60; ++i) {
    walk.to({truth.x + 0.005 * random.gaussian(), truth.y + 0.005 * random.gaussian(),
             truth.theta + deg_to_rad(1.0) * random.gaussian()});
  }
  walk.to(truth);
  EXPECT_NEAR(walk.movement.remaining(), 0.3, 0.01);
}

struct Told {
  std::string words;
  camera::Arrow arrow;
  std::string headline;
};

Told told(const Movement& movement) {
  const camera::Sign sign = as_sign(movement.instruction());
  return {in_words(movement.instruction()), sign.arrow, sign.headline};
}

TEST(HandInstruction, SaysDirectionAmountAndSpeed) {
  using camera::Arrow;
  struct Case {
    DriveGoal goal;
    const char* words;
    Arrow arrow;
    const char* headline;
  };
  const Case cases[] = {
      {{0.42, 0.0, 0.2}, "forward 0.42 m at 0.20 m/s", Arrow::Forward, "0.42 m"},
      {{-0.1, 0.0, 0.2}, "backward 0.10 m at 0.20 m/s", Arrow::Backward, "0.10 m"},
      {{0.0, deg_to_rad(85), 1.0}, "turn left 85 deg at 57 deg/s", Arrow::TurnLeft, "85 deg"},
      {{0.0, deg_to_rad(-85), 1.0}, "turn right 85 deg at 57 deg/s", Arrow::TurnRight, "85 deg"},
      {{0.5, deg_to_rad(45), 0.1},
       "forward, to the left 0.50 m, 45 deg at 0.10 m/s",
       Arrow::CurveLeft,
       "0.50 m, 45 deg"},
      {{-0.5, deg_to_rad(45), 0.1},
       "backward, to the right 0.50 m, 45 deg at 0.10 m/s",
       Arrow::BackRight,
       "0.50 m, 45 deg"},
  };
  for (const Case& c : cases) {
    Movement movement;
    movement.start(c.goal, {});
    const Told t = told(movement);
    EXPECT_EQ(t.words, c.words);
    EXPECT_EQ(t.arrow, c.arrow) << c.words;
    EXPECT_EQ(t.headline, c.headline);
  }
}

TEST(HandInstruction, SaysWhichSpeedToKeep) {
  Movement movement;
  movement.set_speed({0.2, 0.0});
  EXPECT_EQ(told(movement).words, "forward at 0.20 m/s");
  movement.set_speed({0.2, deg_to_rad(-30)});
  EXPECT_EQ(told(movement).words, "forward, to the right at 0.20 m/s, 30 deg/s");
  movement.set_speed({0.0, deg_to_rad(30)});
  EXPECT_EQ(told(movement).words, "turn left at 30 deg/s");
  movement.set_speed({});
  EXPECT_EQ(told(movement).words, "stand still");
  EXPECT_EQ(told(movement).arrow, camera::Arrow::None);
}

TEST(HandInstruction, OfAMovementThatIsMadeIsToStandStill) {
  Walk walk;
  walk.start({0.3, 0.0, 0.2});
  walk.by(0.3);
  EXPECT_EQ(walk.movement.instruction().kind, Kind::Stand);
}

}  // namespace
}  // namespace eyebridge::hal
