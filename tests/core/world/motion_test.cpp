#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world.hpp"
#include "scenes.hpp"

namespace eyebridge::world {
namespace {

using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

MATCHER_P2(Points, x, y, "") { return norm(arg - Vec2{double(x), double(y)}) < 1e-14; }

constexpr double kMotionStep = 0.01;

Arc forward(double metres) { return {{metres, 0.0}, {}}; }

TEST(Motion, FreeWayIsDrivenWhole) {
  World world(shared(room(2, 2)));
  const BodyId robot = world.add_robot({1, 1, kPi / 2}, 0.1, 0.1, {});
  const MoveResult result = world.move(robot, {{0.3, 0.1}, Heading::from_angle(0.25)}, kMotionStep);
  EXPECT_EQ(result.fraction, 1.0);
  EXPECT_FALSE(result.blocked());
  EXPECT_NEAR(world.pose(robot).x, 0.9, 1e-15);
  EXPECT_NEAR(world.pose(robot).y, 1.3, 1e-15);
  EXPECT_NEAR(world.pose(robot).theta, kPi / 2 + 0.25, 1e-15);
}

TEST(Motion, StopsAtTheWallAtTheGapAndTurnsByTheSameFraction) {
  World world(shared(room(2, 2)));
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  const MoveResult result = world.move(robot, {{1.8, 0.0}, Heading::from_angle(0.5)}, kMotionStep);
  EXPECT_TRUE(result.hit_wall);
  EXPECT_EQ(result.hit_body, kNoBody);
  EXPECT_NEAR(result.fraction, 0.5 - kContactGap / 1.8, 1e-14);
  EXPECT_NEAR(world.position(robot).x, 1.9 - kContactGap, 1e-15);
  EXPECT_NEAR(world.pose(robot).theta, 0.5 * result.fraction, 1e-15);
  EXPECT_EQ(result.contact, (Vec2{1.0, 0.0}));
}

TEST(Motion, SlantedApproachStopsWhereTheClosedFormSays) {
  World world(shared(room(2, 2)));
  const double theta = deg_to_rad(30);
  const BodyId robot = world.add_robot({1, 1, theta}, 0.1, 0.1, {});
  const MoveResult result = world.move(robot, forward(2.0), kMotionStep);
  EXPECT_NEAR(result.fraction, (0.9 - kContactGap) / (2.0 * std::cos(theta)), 1e-14);
  EXPECT_NEAR(world.position(robot).y, 1 + (0.9 - kContactGap) * std::tan(theta), 1e-14);
}

TEST(Motion, AWallsEndIsMetAsAPoint) {
  WorldModel model = room(4, 4);
  Wall wall;
  wall.a = {2, 1};
  wall.b = {3, 1};
  model.walls.push_back(wall);
  World world(shared(model));
  const BodyId robot = world.add_robot({1, 1.06, 0}, 0.1, 0.1, {});
  const MoveResult result = world.move(robot, forward(2.0), kMotionStep);
  const double reach = 0.1 + kContactGap;
  EXPECT_NEAR(world.position(robot).x, 2 - std::sqrt(reach * reach - 0.06 * 0.06), 1e-14);
  EXPECT_NEAR(result.contact.y, -0.6, 1e-5);
}

TEST(Motion, RobotsMeetAtTheSumOfTheirRadii) {
  World world(shared(room(4, 4)));
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  const BodyId other = world.add_robot({3, 1.12, 0}, 0.2, 0.1, {});
  const MoveResult result = world.move(robot, forward(2.5), kMotionStep);
  EXPECT_EQ(result.hit_body, other);
  EXPECT_FALSE(result.hit_wall);
  const double reach = 0.3 + kContactGap;
  EXPECT_NEAR(world.position(robot).x, 3 - std::sqrt(reach * reach - 0.12 * 0.12), 1e-14);
}

TEST(Motion, TouchingRobotMayLeaveDriveAlongAndTurnButNotPush) {
  World world(shared(room(2, 2)));
  const BodyId robot = world.add_robot({1.5, 1, 0}, 0.1, 0.1, {});
  ASSERT_TRUE(world.move(robot, forward(1), kMotionStep).blocked());
  EXPECT_EQ(world.move(robot, forward(0.01), kMotionStep).fraction, 0.0);
  EXPECT_EQ(world.move(robot, {{0, 0.2}, {}}, kMotionStep).fraction, 1.0);  // along the wall
  EXPECT_EQ(world.move(robot, {{0, -0.2}, {}}, kMotionStep).fraction, 1.0);
  EXPECT_EQ(world.move(robot, {{}, Heading::from_angle(1)}, kMotionStep).fraction, 1.0);
  EXPECT_NEAR(world.pose(robot).theta, 1.0, 1e-15);
  EXPECT_EQ(world.move(robot, forward(-0.05), kMotionStep).fraction, 1.0);
}

/// How far from a wall a body of radius 0.1 m slides along it.
constexpr double kAlongWall = 0.1 + kContactGap;

TEST(Slide, GoesOnAlongTheWallByWhatTheFrictionLeaves) {
  for (const double degrees : {10.0, 45.0, 70.0}) {
    for (const double friction : {0.0, 0.2}) {
      World world(shared(room(4, 2)));
      const double angle = deg_to_rad(degrees);
      const BodyId robot = world.add_robot({1, 0.15, -angle}, 0.1, 0.1, {});
      const ContactLaw law{.slides = true, .friction = friction};
      const MoveResult result = world.move(robot, forward(0.8), kMotionStep, law);
      const double before = (0.15 - kAlongWall) / std::sin(angle);
      const double after = (0.8 - before) * (std::cos(angle) - friction * std::sin(angle));
      EXPECT_TRUE(result.hit_wall);
      EXPECT_TRUE(result.slid);
      EXPECT_NEAR(result.fraction, before / 0.8, 1e-12);
      EXPECT_NEAR(world.position(robot).x, 1 + before * std::cos(angle) + after, 1e-8) << degrees;
      EXPECT_NEAR(world.position(robot).y, kAlongWall, 1e-8);
      EXPECT_NEAR(result.progress, (before + after * std::cos(angle)) / 0.8, 1e-8) << degrees;
    }
  }
}

TEST(Slide, StandsWhereTheLawIsToStandOrFrictionHoldsIt) {
  for (const ContactLaw law : {ContactLaw{}, ContactLaw{.slides = true, .friction = 1.0}}) {
    World world(shared(room(4, 2)));
    const BodyId robot = world.add_robot({1, 0.15, -deg_to_rad(46)}, 0.1, 0.1, {});
    const MoveResult result = world.move(robot, forward(0.8), kMotionStep, law);
    EXPECT_FALSE(result.slid);
    EXPECT_EQ(result.progress, result.fraction);
    EXPECT_NEAR(world.position(robot).y, kAlongWall, 1e-12);
    EXPECT_NEAR(norm(world.position(robot) - Vec2{1, 0.15}), 0.8 * result.fraction, 1e-12);
  }
}

TEST(Slide, TurnsByWhatItMadeOfTheWayUnlessTheLawTurns) {
  for (const bool turns : {false, true}) {
    World world(shared(room(4, 2)));
    const BodyId robot = world.add_robot({1, 0.15, -deg_to_rad(30)}, 0.1, 0.1, {});
    const ContactLaw law{.slides = true, .turns = turns, .friction = 0.1};
    const MoveResult result =
        world.move(robot, {{0.8, 0.0}, Heading::from_angle(0.4)}, kMotionStep, law);
    ASSERT_LT(result.progress, 0.9);
    EXPECT_NEAR(world.pose(robot).theta + deg_to_rad(30), turns ? 0.4 : 0.4 * result.progress,
                1e-12);
  }
}

TEST(Slide, DoesNotGoBackIntoWhatItSlidAlong) {
  // Along a step's edge to a wall across the way, which would lead down beyond the step.
  WorldModel model = room(4, 4);
  Wall step;
  step.a = {0, 2};
  step.b = {2, 2};
  model.walls.push_back(step);
  World world(shared(model));
  const BodyId robot = world.add_robot({1, 2.1 + 1e-6, -deg_to_rad(30)}, 0.1, 0.1, {});
  const ContactLaw law{.slides = true};
  const MoveResult result = world.move(robot, forward(5), kMotionStep, law);
  EXPECT_TRUE(result.slid);
  EXPECT_NEAR(world.position(robot).x, 3.9 - kContactGap, 1e-8);
  EXPECT_NEAR(world.position(robot).y, 2.1, 1e-5) << "where it met the wall";
  world.move(robot, forward(0.1), kMotionStep, law);
  EXPECT_LT(world.position(robot).y, 2.06) << "the next step leads on";
}

TEST(Slide, HoldsInASharpCornerToTheBit) {
  WorldModel model = room(4, 4);
  Wall slope;
  slope.a = {4, 0};
  slope.b = {0, 1.5};
  model.walls.push_back(slope);
  World world(shared(model));
  const BodyId robot = world.add_robot({2, 0.2, -deg_to_rad(30)}, 0.1, 0.1, {});
  const ContactLaw law{.slides = true};
  for (int i = 0; i < 300; ++i) world.move(robot, forward(0.01), kMotionStep, law);
  const Vec2 held = world.position(robot);
  EXPECT_GT(held.x, 2.5);
  for (int i = 0; i < 100; ++i) {
    const MoveResult result = world.move(robot, forward(0.01), kMotionStep, law);
    EXPECT_EQ(result.fraction, 0.0);
    EXPECT_FALSE(result.slid);
    ASSERT_EQ(world.position(robot), held) << i;
  }
}

TEST(Motion, DrivingAlongARowOfWallsMeetsNoJoint) {
  WorldModel model = random_maze(1, 12, 0.0);  // its boundary is a row of single walls
  World world(shared(model));
  const BodyId robot = world.add_robot({0.5, 0.3, -kPi / 2}, 0.1, 0.1, {});
  ASSERT_TRUE(world.move(robot, forward(1), kMotionStep).hit_wall);
  for (int i = 0; i < 300; ++i) {
    ASSERT_EQ(world.move(robot, {{0, 0.01}, {}}, kMotionStep).fraction, 1.0) << i;
  }
  EXPECT_NEAR(world.position(robot).x, 3.5, 1e-12);
}

TEST(Motion, NothingTunnelsAtAnySpeed) {
  World world(shared(room(2, 2)));
  const BodyId robot = world.add_robot({1, 1, 0.3}, 0.05, 0.1, {});
  for (const double speed : {1.0, 1e3, 1e6, 1e9}) {
    world.set_pose(robot, {1, 1, 0.3});
    EXPECT_TRUE(world.move(robot, forward(speed), kMotionStep).hit_wall);
    EXPECT_LT(world.position(robot).x, 1.95);
  }
}

TEST(Motion, RobotPutIntoAWallDrivesOutButNotDeeper) {
  for (const double thickness : {0.0, 0.3}) {
    WorldModel model = room(4, 4);
    Wall wall;
    wall.a = {2, 1};
    wall.b = {2, 3};
    wall.thickness = thickness;
    model.walls.push_back(wall);
    World world(shared(model));
    const BodyId robot = world.add_robot({1, 2, 0}, 0.1, 0.1, {});
    const double edge = 2 - thickness / 2;
    world.set_pose(robot, {edge - 0.04, 2, 0});
    EXPECT_EQ(world.move(robot, forward(0.01), kMotionStep).fraction, 0.0) << thickness;
    EXPECT_EQ(world.move(robot, forward(-0.01), kMotionStep).fraction, 1.0) << thickness;
    world.set_pose(robot, {2.01, 2, 0});  // centre in the wall, or just beyond it
    EXPECT_EQ(world.move(robot, forward(0.5), kMotionStep).fraction, 1.0) << thickness;
  }
}

TEST(World, AddRobotRefusesOverlapsAndSaysByHowMuch) {
  World world(shared(room(2, 2)));
  world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  try {
    world.add_robot({1.15, 1, 0}, 0.1, 0.1, {});
    FAIL() << "overlapping body accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("overlaps body 0"));
    EXPECT_THAT(error.what(), HasSubstr("by 0.0500 m"));
  }
  try {
    world.add_robot({0.08, 1, 0}, 0.1, 0.1, {});
    FAIL() << "robot in a wall accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("0.0200 m deep in a wall"));
  }
  EXPECT_EQ(world.body_count(), 1u);
}

TEST(World, ContactsPointAtWallsAndBodies) {
  World world(shared(room(2, 2)));
  const BodyId robot = world.add_robot({0.105, 0.105, 0}, 0.1, 0.1, {});
  world.add_robot({0.312, 0.105, 0}, 0.1, 0.1, {});
  std::vector<Vec2> contacts;
  world.contacts(robot, 0.01, contacts);
  EXPECT_THAT(contacts, UnorderedElementsAre(Points(0, -1), Points(-1, 0), Points(1, 0)));
  contacts.clear();
  world.contacts(robot, 0.006, contacts);
  EXPECT_EQ(contacts.size(), 2u);
}

TEST(World, ContactsWithoutReachNameWhatStoppedTheRobot) {
  World world(shared(room(2, 2)));
  const BodyId robot = world.add_robot({1, 1, 0.7}, 0.1, 0.1, {});
  const MoveResult result = world.move(robot, forward(5), kMotionStep);
  std::vector<Vec2> contacts;
  world.contacts(robot, 0.0, contacts);
  EXPECT_THAT(contacts, ::testing::ElementsAre(result.contact));
}

TEST(World, IsFreeSeesWallsThickWallsAndBodiesButNotTheIgnoredOne) {
  WorldModel model = room(4, 4);
  Wall block;
  block.a = {2, 1};
  block.b = {2, 3};
  block.thickness = 1.0;
  model.walls.push_back(block);
  World world(shared(model));
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  EXPECT_FALSE(world.is_free({1.15, 1}, 0.1));
  EXPECT_TRUE(world.is_free({1.15, 1}, 0.1, robot));
  EXPECT_TRUE(world.is_free({1.25, 1}, 0.1));
  EXPECT_FALSE(world.is_free({2, 2}, 0.05)) << "inside of a thick wall";
  EXPECT_FALSE(world.is_free({1.45, 2}, 0.06));
  EXPECT_TRUE(world.is_free({1.45, 2}, 0.04));
}

TEST(World, RaysSeeBodiesButNotTheIgnoredOne) {
  World world(shared(room(4, 4)));
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  world.add_robot({2, 1.03, 0}, 0.05, 0.1, {});
  EXPECT_NEAR(world.cast_ray({1, 1}, {1, 0}, 9, robot), 1 - 0.04, 1e-15);
  EXPECT_NEAR(world.cast_ray({1, 1}, {-1, 0}, 9, robot), 1, 1e-15);
  EXPECT_NEAR(world.cast_ray({0.5, 1}, {1, 0}, 9, kNoBody), 0.4, 1e-15);
  EXPECT_EQ(world.cast_ray({1, 1}, {1, 0}, 0.5, robot), 0.5);
}

}  // namespace
}  // namespace eyebridge::world
