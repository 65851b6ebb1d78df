#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world.hpp"
#include "scenes.hpp"

namespace eyebridge::world {
namespace {

constexpr double kReactionStep = 0.01;

ObjectSpec reacting(Reaction::Kind kind, double speed, double range = HUGE_VAL) {
  ObjectSpec spec;
  spec.kind = ObjectKind::Can;
  spec.pose = {2, 2, 0.3};
  spec.radius = 0.05;
  spec.reaction = Reaction{kind, speed, range};
  return spec;
}

World world_with(ObjectSpec object, std::uint64_t seed = 1) {
  WorldModel model = room(4, 4);
  model.objects.push_back(std::move(object));
  return World(shared(std::move(model)), seed);
}

void let_pass(World& world, double seconds) {
  for (int i = 0; i < std::lround(seconds / kReactionStep); ++i) world.step_objects(kReactionStep);
}

std::uint64_t hash_of_state(const World& world) {
  StateHash hash;
  world.add_to(hash);
  return hash.value();
}

TEST(Reactions, WhatFollowsGoesToTheNearestRobotAndTouchesIt) {
  World world = world_with(reacting(Reaction::Kind::Follow, 0.2));
  const BodyId far_one = world.add_robot({0.5, 2, 0}, 0.1, 0.1, {});
  const BodyId near_one = world.add_robot({3, 2, 0}, 0.2, 0.1, {});
  let_pass(world, 1.0);
  EXPECT_NEAR(world.position(0).x, 2.2, 1e-9);
  let_pass(world, 5.0);
  EXPECT_NEAR(world.position(0).x, 2.75, 1e-6) << "rim to rim";
  EXPECT_NEAR(world.heading(0).angle(), 0.3, 1e-12);
  EXPECT_EQ(world.position(near_one), (Vec2{3, 2})) << "robots are not pushed";
  world.remove(near_one);
  let_pass(world, 1.0);
  EXPECT_NEAR(world.position(0).x, 2.55, 1e-6) << "then the other one";
  EXPECT_FALSE(world.gives_way(0));
  world.remove(far_one);
  let_pass(world, 1.0);
  EXPECT_NEAR(world.position(0).x, 2.55, 1e-6) << "nobody is left";
}

TEST(Reactions, RobotsBeyondTheRangeDoNotCount) {
  World world = world_with(reacting(Reaction::Kind::Flee, 0.2, 0.5));
  const BodyId robot = world.add_robot({1.3, 2, 0}, 0.1, 0.1, {});
  let_pass(world, 1.0);
  EXPECT_EQ(world.position(0), (Vec2{2, 2})) << "0.55 m between the rims";
  world.set_pose(robot, {1.5, 2, 0});
  let_pass(world, 3.0);
  EXPECT_NEAR(world.position(0).x, 1.5 + 0.1 + 0.05 + 0.5, 0.003) << "so far and no farther";
}

TEST(Reactions, WhatFleesSlipsAlongAWall) {
  ObjectSpec object = reacting(Reaction::Kind::Flee, 0.3);
  object.pose = {3.9, 2, 0};
  World world = world_with(object);
  world.add_robot({3, 1.9, 0}, 0.1, 0.1, {});
  let_pass(world, 5.0);
  EXPECT_NEAR(world.position(0).x, 3.95, 1e-6);
  EXPECT_GT(world.position(0).y, 2.2);
}

TEST(Reactions, WhatFollowsPassesAnObstacleAlongItsFace) {
  WorldModel model = room(4, 4);
  model.objects.push_back(reacting(Reaction::Kind::Follow, 0.3));
  Wall wall;
  wall.a = {2.5, 1.5};
  wall.b = {2.5, 2.2};
  model.walls.push_back(wall);
  World world(shared(std::move(model)));
  world.add_robot({3.5, 2.6, 0}, 0.1, 0.1, {});
  let_pass(world, 12.0);
  EXPECT_GT(world.position(0).x, 3.2);
}

TEST(Reactions, WhatWandersGoesAtItsSpeedBouncesAndStaysInside) {
  World world = world_with(reacting(Reaction::Kind::Wander, 0.5));
  Vec2 last = world.position(0);
  double least_x = 4;
  double most_x = 0;
  int slow = 0;
  for (int i = 0; i < 20000; ++i) {
    world.step_objects(kReactionStep);
    const Vec2 now = world.position(0);
    const double way = norm(now - last);
    EXPECT_LE(way, 0.005 + 1e-9);
    if (way < 0.0049) ++slow;
    least_x = std::min(least_x, now.x);
    most_x = std::max(most_x, now.x);
    last = now;
  }
  EXPECT_NEAR(least_x, 0.05, 0.01);
  EXPECT_NEAR(most_x, 3.95, 0.01);
  EXPECT_LT(slow, 300) << "it stands at no wall";
}

TEST(Reactions, WanderingIsTheSameForASeedAndAnotherForAnother) {
  const auto end = [](std::uint64_t seed) {
    World world = world_with(reacting(Reaction::Kind::Wander, 0.5), seed);
    let_pass(world, 30.0);
    return hash_of_state(world);
  };
  EXPECT_EQ(end(1), end(1));
  EXPECT_NE(end(1), end(2));
}

TEST(Reactions, WhatWandersYieldsToRobots) {
  ObjectSpec object = reacting(Reaction::Kind::Wander, 0.5);
  object.yields_within = 0.2;
  World world = world_with(object);
  world.add_robot({2.25, 2, 0}, 0.1, 0.1, {});
  let_pass(world, 1.0);
  EXPECT_EQ(world.position(0), (Vec2{2, 2}));
}

TEST(Reactions, OneThatCameLaterReactsAndARemovedOneDoesNot) {
  World world(shared(room(4, 4)));
  world.add_robot({3, 2, 0}, 0.1, 0.1, {});
  const BodyId hound = world.add_object(reacting(Reaction::Kind::Follow, 0.2));
  EXPECT_TRUE(world.moves_by_itself(hound));
  let_pass(world, 1.0);
  EXPECT_NEAR(world.position(hound).x, 2.2, 1e-9);
  world.remove(hound);
  let_pass(world, 1.0);
  EXPECT_NEAR(world.position(hound).x, 2.2, 1e-9);
}

}  // namespace
}  // namespace eyebridge::world
