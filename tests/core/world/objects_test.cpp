#include <cmath>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world.hpp"
#include "scenes.hpp"

namespace eyebridge::world {
namespace {

constexpr double kObjectStep = 0.01;

ObjectSpec object(ObjectKind kind, double x, double y) {
  ObjectSpec spec;
  spec.kind = kind;
  spec.pose = {x, y, 0};
  spec.radius = kind == ObjectKind::Ball ? 0.02 : 0.03;
  return spec;
}

World world_with(WorldModel model, std::initializer_list<ObjectSpec> objects) {
  model.objects = objects;
  return World(shared(std::move(model)));
}

void drive(World& world, BodyId robot, double step, int steps) {
  for (int i = 0; i < steps; ++i) {
    world.move(robot, {{step, 0}, {}}, kObjectStep);
    world.step_objects(kObjectStep);
  }
}

void roll(World& world, int steps) {
  for (int i = 0; i < steps; ++i) world.step_objects(kObjectStep);
}

TEST(Objects, AreTheFirstBodiesInTheirOrder) {
  World world =
      world_with(room(2, 2), {object(ObjectKind::Can, 1, 1), object(ObjectKind::Ball, 0.5, 1)});
  EXPECT_EQ(world.object_count(), 2u);
  EXPECT_EQ(world.add_robot({0.2, 0.2, 0}, 0.1, 0.1, {1, 2, 3}), 2u);
  const Scene scene = world.scene(1.5);
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(scene.bodies[0].shape, BodyShape::Can);
  EXPECT_EQ(scene.bodies[1].shape, BodyShape::Ball);
  EXPECT_EQ(scene.bodies[1].pose, (Pose{0.5, 1, 0}));
  EXPECT_EQ(scene.bodies[2].shape, BodyShape::Robot);
  EXPECT_EQ(scene.bodies[2].colour, (Rgb{1, 2, 3}));
  EXPECT_EQ(scene.time, 1.5);
}

TEST(Objects, ACanIsPushedInFrontAndStandsStillAfterwards) {
  World world = world_with(room(4, 2), {object(ObjectKind::Can, 1.5, 1)});
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  drive(world, robot, 0.01, 100);
  EXPECT_NEAR(world.position(robot).x, 2.0, 1e-12) << "the can did not slow it";
  EXPECT_NEAR(world.position(0).x, 2.0 + 0.13, 1e-6);
  EXPECT_EQ(world.position(0).y, 1.0);
  const Vec2 before = world.position(0);
  roll(world, 100);
  EXPECT_EQ(world.position(0), before);
}

TEST(Objects, ACanAtTheWallHoldsTheRobot) {
  World world = world_with(room(2, 2), {object(ObjectKind::Can, 1.5, 1)});
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  drive(world, robot, 0.01, 200);
  EXPECT_NEAR(world.position(0).x, 2 - 0.03, 1e-6);
  EXPECT_NEAR(world.position(robot).x, 2 - 0.06 - 0.1, 1e-6);
  const MoveResult result = world.move(robot, {{0.01, 0}, {}}, kObjectStep);
  EXPECT_EQ(result.hit_body, 0u);
  EXPECT_FALSE(result.hit_wall);
  EXPECT_LT(result.fraction, 1e-6);
  EXPECT_NEAR(result.contact.x, 1.0, 1e-12);
}

TEST(Objects, WhatIsSqueezedObliquelyAgainstAWallSlipsAlongIt) {
  for (const ObjectKind kind : {ObjectKind::Can, ObjectKind::Ball}) {
    const ObjectSpec spec = object(kind, 1.5, kind == ObjectKind::Can ? 0.0301 : 0.0201);
    World world = world_with(room(4, 2), {spec});
    const BodyId robot = world.add_robot({1, 0.11, 0}, 0.1, 0.1, {});
    for (int i = 0; i < 150; ++i) {
      ASSERT_FALSE(world.move(robot, {{0.01, 0}, {}}, kObjectStep).blocked()) << i;
      world.step_objects(kObjectStep);
    }
    EXPECT_NEAR(world.position(robot).x, 2.5, 1e-12) << "it did not slow the robot";
    EXPECT_NEAR(world.position(robot).y, 0.11, 1e-12);
    EXPECT_GT(world.position(0).x, 2.55);
    EXPECT_GE(world.position(0).y, spec.radius);
  }
}

TEST(Objects, ACanBetweenARobotAndTheWallGetsOutOfTheWay) {
  World world = world_with(room(4, 2), {object(ObjectKind::Can, 1.95, 0.031)});
  const BodyId robot = world.add_robot({1.5, 0.5, -kPi / 4}, 0.1, 0.1, {});
  drive(world, robot, 0.01, 100);
  EXPECT_NEAR(world.position(robot).y, 0.1, 1e-6) << "the robot came to the wall";
  EXPECT_NEAR(world.position(0).y, 0.03, 1e-6);
  EXPECT_NEAR(norm(world.position(0) - world.position(robot)), 0.13, 0.02);
}

TEST(Objects, ACanThatIsPushedSteeplyAgainstAWallJams) {
  World world = world_with(room(2, 2), {object(ObjectKind::Can, 1.9, 1.015)});
  const BodyId robot = world.add_robot({1.5, 1, 0}, 0.1, 0.1, {});
  drive(world, robot, 0.01, 100);
  EXPECT_LT(world.position(robot).x, 2 - 0.06 - 0.09);
  EXPECT_EQ(world.move(robot, {{0.01, 0}, {}}, kObjectStep).hit_body, 0u);
}

TEST(Objects, ARowOfCansIsPushedTogether) {
  World world =
      world_with(room(4, 2), {object(ObjectKind::Can, 1.5, 1), object(ObjectKind::Can, 1.7, 1),
                              object(ObjectKind::Can, 1.9, 1)});
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  drive(world, robot, 0.02, 70);
  EXPECT_NEAR(world.position(robot).x, 2.4, 1e-9);
  for (BodyId can = 0; can < 3; ++can) {
    EXPECT_NEAR(world.position(can).x, 2.4 + 0.13 + 0.06 * can, 1e-5);
  }
}

TEST(Objects, AnOffCentrePushMovesTheCanAside) {
  World world = world_with(room(4, 2), {object(ObjectKind::Can, 1.5, 1.05)});
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  drive(world, robot, 0.01, 200);
  EXPECT_NEAR(world.position(robot).x, 3.0, 1e-12);
  EXPECT_GT(world.position(0).y, 1.1) << "the robot went past";
}

TEST(Objects, AHitBallLeavesFasterThanTheRobotAndRollsOutInAParabola) {
  World world = world_with(room(9, 2), {object(ObjectKind::Ball, 1.2, 1)});
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  drive(world, robot, 0.005, 20);  // 0.5 m/s, into the ball
  ASSERT_GT(world.position(0).x, 1.22);
  // With v its speed now: a step of v dt - a dt^2 / 2, and v^2 / 2a to where it rests.
  constexpr double kDeceleration = 0.3;
  const double start = world.position(0).x;
  roll(world, 1);
  const double speed =
      (world.position(0).x - start) / kObjectStep + kDeceleration * kObjectStep / 2;
  EXPECT_LT(speed, 0.75) << "1.5 times the robot's";
  EXPECT_GT(speed, 0.70);
  roll(world, 1000);
  EXPECT_NEAR(world.position(0).x - start, speed * speed / (2 * kDeceleration), 1e-9);
  const Vec2 rest = world.position(0);
  roll(world, 10);
  EXPECT_EQ(world.position(0), rest);
}

TEST(Objects, ARollingBallBouncesOffTheWall) {
  World world = world_with(room(2, 2), {object(ObjectKind::Ball, 1.6, 1)});
  const BodyId robot = world.add_robot({1.4, 1, 0}, 0.1, 0.1, {});
  drive(world, robot, 0.01, 12);
  roll(world, 15);
  const double near_wall = world.position(0).x;
  world.set_pose(robot, {0.2, 0.2, 0});
  roll(world, 20);
  EXPECT_LT(world.position(0).x, near_wall);
  EXPECT_EQ(world.position(0).y, 1.0);
}

TEST(Objects, ABallPassesItsSpeedOnToAnotherBall) {
  World world =
      world_with(room(4, 2), {object(ObjectKind::Ball, 1.2, 1), object(ObjectKind::Ball, 1.4, 1)});
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  drive(world, robot, 0.005, 18);
  roll(world, 600);
  EXPECT_GT(world.position(1).x, 1.8);
  EXPECT_LT(world.position(0).x, world.position(1).x - 0.1);
}

TEST(Objects, BallsLoseEnergyAndStayInTheirRoom) {
  WorldModel model = room(1, 1);
  for (int i = 0; i < 20; ++i) {
    const int row = i / 5;
    model.objects.push_back(object(i % 4 == 3 ? ObjectKind::Can : ObjectKind::Ball,
                                   0.15 + 0.17 * (i % 5), 0.3 + 0.17 * row));
  }
  World world(shared(model));
  const BodyId robot = world.add_robot({0.5, 0.1, kPi / 2}, 0.06, 0.1, {});
  drive(world, robot, 0.02, 30);  // 2 m/s through the middle
  std::vector<Vec2> before(20);
  const auto way_rolled = [&](int steps) {
    double way = 0;
    for (int i = 0; i < steps; ++i) {
      for (BodyId id = 0; id < 20; ++id) before[id] = world.position(id);
      world.step_objects(kObjectStep);
      for (BodyId id = 0; id < 20; ++id) way += norm_squared(world.position(id) - before[id]);
    }
    return way;
  };
  double last = way_rolled(20);
  ASSERT_GT(last, 0.0) << "nothing was hit";
  for (int round = 0; round < 10; ++round) {
    const double now = way_rolled(20);
    EXPECT_LE(now, last);
    last = now;
  }
  EXPECT_EQ(way_rolled(1000) * 0 + way_rolled(10), 0.0) << "everything has come to rest";
  for (BodyId id = 0; id < 20; ++id) {
    const Vec2 p = world.position(id);
    const double r = world.radius(id);
    EXPECT_TRUE(p.x >= r && p.x <= 1 - r && p.y >= r && p.y <= 1 - r) << id;
  }
}

TEST(Objects, SetPosePutsABallToRest) {
  World world = world_with(room(4, 2), {object(ObjectKind::Ball, 1.2, 1)});
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  drive(world, robot, 0.01, 12);
  world.set_pose(0, {2, 1.5, 0});
  roll(world, 50);
  EXPECT_EQ(world.position(0), (Vec2{2, 1.5}));
}

}  // namespace
}  // namespace eyebridge::world
