#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world.hpp"
#include "overlap.hpp"
#include "scenes.hpp"

namespace eyebridge::world {
namespace {

constexpr double kMatterStep = 0.01;

ObjectSpec thing(ObjectKind kind, double x, double y, const Matter& matter) {
  ObjectSpec spec;
  spec.kind = kind;
  spec.pose = {x, y, 0};
  spec.size = {0.05, 0.04};
  spec.corners = {{0.035, 0.0}, {0.0, 0.03}, {-0.03, 0.01}, {-0.02, -0.03}};
  spec.matter = matter;
  return spec;
}

World world_holding(WorldModel model, std::vector<ObjectSpec> objects) {
  model.objects = std::move(objects);
  return World(shared(std::move(model)));
}

void let_slide(World& world, int steps) {
  for (int i = 0; i < steps; ++i) world.step_objects(kMatterStep);
}

TEST(Matter, FrictionStopsAfterTheWayOfAConstantDeceleration) {
  for (const ObjectKind kind : {ObjectKind::Ball, ObjectKind::Can, ObjectKind::Box}) {
    World world = world_holding(room(9, 2), {thing(kind, 1, 1, {.friction = 0.1})});
    world.set_velocity(0, {2, 0});
    let_slide(world, 1000);
    EXPECT_NEAR(world.position(0).x, 1 + 2 * 2 / (2 * 0.1 * kGravity), 1e-9);
    EXPECT_EQ(world.velocity(0), Vec2{});
  }
}

TEST(Matter, WithoutFrictionCansAndBoxesStandAndBallsSlowDown) {
  for (const ObjectKind kind : {ObjectKind::Can, ObjectKind::Box}) {
    World world = world_holding(room(4, 2), {thing(kind, 1, 1, {})});
    world.set_velocity(0, {1, 0});
    let_slide(world, 10);
    EXPECT_EQ(world.position(0), (Vec2{1, 1}));
  }
  World world = world_holding(room(4, 2), {thing(ObjectKind::Ball, 1, 1, {})});
  world.set_velocity(0, {1, 0});
  let_slide(world, 1000);
  EXPECT_NEAR(world.position(0).x, 1 + 1 / (2 * 0.3), 1e-9);
}

TEST(Matter, RestitutionIsTheShareOfTheSpeedThatABounceLeaves) {
  for (const double restitution : {0.0, 0.3, 1.0}) {
    World world = world_holding(
        room(4, 2), {thing(ObjectKind::Ball, 3, 1, {.friction = 0.0, .restitution = restitution})});
    world.set_velocity(0, {2, 0.5});
    let_slide(world, 60);
    EXPECT_NEAR(world.velocity(0).x, -2 * restitution, 1e-12);
    EXPECT_NEAR(world.velocity(0).y, 0.5, 1e-12) << "along the wall nothing changes";
  }
}

TEST(Matter, WhatSlidesIsHitAsNewtonsLawOfRestitutionSays) {
  Matter light{.mass = 0.1, .friction = 0.0, .restitution = 0.5};
  Matter heavy{.mass = 0.3, .friction = 0.0, .restitution = 0.2};
  World world = world_holding(
      room(9, 2), {thing(ObjectKind::Ball, 1, 1, light), thing(ObjectKind::Box, 2, 1, heavy)});
  world.set_velocity(0, {2, 0});
  let_slide(world, 100);
  // The larger of the two restitutions counts: v = 2 * (0.1 - 0.5 * 0.3) / 0.4, 2 * 1.5 * 0.1 /
  // 0.4.
  EXPECT_NEAR(world.velocity(0).x, -0.25, 1e-12);
  EXPECT_NEAR(world.velocity(1).x, 0.75, 1e-12);
}

TEST(Matter, WhatIsFixedHoldsRobotsAndBalls) {
  World world = world_holding(room(4, 2), {thing(ObjectKind::Can, 2, 1, {.fixed = true}),
                                           thing(ObjectKind::Ball, 1.5, 1, {.friction = 0.0})});
  world.set_velocity(1, {1, 0});
  let_slide(world, 100);
  EXPECT_NEAR(world.velocity(1).x, -0.6, 1e-12);
  const BodyId robot = world.add_robot({2, 0.5, kPi / 2}, 0.1, 0.1, {});
  MoveResult result;
  for (int i = 0; i < 60; ++i) result = world.move(robot, {{0.01, 0}, {}}, kMatterStep);
  EXPECT_EQ(result.hit_body, 0u);
  EXPECT_EQ(world.position(0), (Vec2{2, 1}));
  EXPECT_NEAR(world.position(robot).y, 1 - 0.02 - 0.1, 1e-6);
}

TEST(Matter, AKickedThingLeavesTheRobotBehind) {
  const Matter ice{.friction = 0.05, .restitution = 1.0};
  World world = world_holding(room(9, 2), {thing(ObjectKind::Can, 1.2, 1, ice)});
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  for (int i = 0; i < 20; ++i) {
    world.move(robot, {{0.005, 0}, {}}, kMatterStep);
    world.step_objects(kMatterStep);
  }
  EXPECT_NEAR(world.velocity(0).x, 1.0, 0.1) << "twice the robot's 0.5 m/s, less friction";
}

TEST(Matter, WhatCannotBeIsRefused) {
  const auto refused = [](Matter matter, Vec2 size) {
    ObjectSpec spec = thing(ObjectKind::Box, 1, 1, matter);
    spec.size = size;
    EXPECT_THROW(world_holding(room(2, 2), {spec}), std::invalid_argument);
  };
  refused({.mass = 0.0}, {0.1, 0.1});
  refused({.friction = -0.1}, {0.1, 0.1});
  refused({.restitution = 1.1}, {0.1, 0.1});
  refused({.restitution = std::numeric_limits<double>::quiet_NaN()}, {0.1, 0.1});
  refused({}, {0.1, 0.0});
}

/// Balls, cans and boxes of all masses that slide in a closed room, at random speeds.
World billiard(std::uint64_t seed, double friction, double restitution) {
  Random random(seed);
  std::vector<ObjectSpec> objects;
  for (int i = 0; i < 36; ++i) {
    const Matter matter{.mass = 0.02 + random.uniform(),
                        .friction = friction,
                        .restitution = restitution * random.uniform()};
    const int row = i / 6;
    objects.push_back(
        thing(static_cast<ObjectKind>(i % 4), 0.12 + 0.15 * (i % 6), 0.12 + 0.15 * row, matter));
    objects.back().pose.theta = 2 * kPi * random.uniform();
  }
  World world = world_holding(room(1, 1), objects);
  for (BodyId id = 0; id < world.object_count(); ++id) {
    world.set_velocity(id, {4 * random.uniform() - 2, 4 * random.uniform() - 2});
  }
  return world;
}

double energy(const World& world) {
  double sum = 0.0;
  for (BodyId id = 0; id < world.object_count(); ++id) {
    sum += world.model().objects[id].matter.mass * norm_squared(world.velocity(id)) / 2;
  }
  return sum;
}

TEST(MatterInvariants, EnergyNeverGrowsAndNothingOverlaps) {
  for (const double restitution : {0.5, 1.0}) {
    for (const double friction : {0.0, 0.02}) {
      World world = billiard(90, friction, restitution);
      double last = energy(world);
      const double first = last;
      for (int step = 0; step < 2000; ++step) {
        world.step_objects(kMatterStep);
        const double now = energy(world);
        ASSERT_LE(now, last * (1 + 1e-14)) << "step " << step;
        last = now;
        if (step % 10 == 0) {
          ASSERT_EQ(deepest_of_all(world), 0.0) << "step " << step;
        }
      }
      EXPECT_LT(last, 0.9 * first);
    }
  }
}

TEST(MatterInvariants, MomentumStaysWhateverMeetsAwayFromWalls) {
  Random random(91);
  int met = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<ObjectSpec> objects;
    for (int i = 0; i < 2; ++i) {
      const Matter matter{
          .mass = 0.01 + random.uniform(), .friction = 0.0, .restitution = random.uniform()};
      const auto kind = static_cast<ObjectKind>(random.bits() % 4);
      objects.push_back(thing(kind, 20 + 0.2 * i, 20 + 0.02 * random.uniform(), matter));
      objects.back().pose.theta = 2 * kPi * random.uniform();
    }
    World world = world_holding(room(40, 40), objects);
    world.set_velocity(0, {1 + random.uniform(), 0.1 * random.uniform()});
    world.set_velocity(1, {-random.uniform(), 0.0});
    const auto momentum = [&] {
      return objects[0].matter.mass * world.velocity(0) +
             objects[1].matter.mass * world.velocity(1);
    };
    const Vec2 before = momentum();
    const Vec2 speed = world.velocity(0);
    let_slide(world, 100);
    EXPECT_NEAR(momentum().x, before.x, 1e-14);
    EXPECT_NEAR(momentum().y, before.y, 1e-14);
    met += world.velocity(0) == speed ? 0 : 1;
  }
  EXPECT_GT(met, 100);
}

}  // namespace
}  // namespace eyebridge::world
