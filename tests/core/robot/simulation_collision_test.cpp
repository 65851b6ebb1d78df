#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "rig.hpp"

namespace eyebridge::robot {
namespace {

/// A room of 4 m x 4 m with `objects`.
std::shared_ptr<const world::WorldModel> room_with(std::vector<world::ObjectSpec> objects) {
  auto model = std::make_shared<world::WorldModel>(*room(4.0, 4.0));
  model->objects = std::move(objects);
  return model;
}

world::ObjectSpec golf(double x, double y) {
  world::ObjectSpec ball;
  ball.pose = {x, y, 0.0};
  return ball;
}

TEST(Collision, WithARobotNamesBoth) {
  Rig rig({}, {1.0, 2.0, 0.0});
  const RobotIndex other = rig.sim.add_robot({}, {1.5, 2.0, 0.0});
  rig.sim.set_speed(rig.robot, {0.3, 0.0});
  rig.steps(300);
  ASSERT_EQ(rig.sim.collisions().size(), 1u);
  const CollisionEvent& event = rig.sim.collisions()[0];
  EXPECT_EQ(event.robot, rig.robot);
  EXPECT_EQ(event.with_robot, other);
  EXPECT_EQ(event.with_body, rig.sim.body(other));
  EXPECT_FALSE(event.with_wall());
  EXPECT_NEAR(event.place.x, 1.5 - 0.093, 1e-6);
  EXPECT_NEAR(event.place.y, 2.0, 1e-9);
}

TEST(Collision, ThatTwoRobotsHaveWithEachOtherIsOne) {
  Rig rig({}, {1.0, 2.0, 0.0});
  const RobotIndex other = rig.sim.add_robot({}, {2.0, 2.0, kPi});
  rig.sim.set_speed(rig.robot, {0.3, 0.0});
  rig.sim.set_speed(other, {0.3, 0.0});
  rig.steps(500);
  EXPECT_EQ(rig.sim.collision_count(), 1u);
}

TEST(Collision, WithAWallIsToldOfWhileAnotherContactLasts) {
  Rig rig({}, {3.5, 2.0, 0.0});
  const RobotIndex other = rig.sim.add_robot({}, {3.5, 2.187, 0.0});  // a millimetre beside it
  rig.sim.set_speed(other, {0.0, -0.0});
  rig.sim.set_speed(rig.robot, {0.3, 0.0});
  rig.steps(300);
  ASSERT_EQ(rig.sim.collisions().size(), 1u);
  rig.sim.drive(rig.robot, {0.0, kPi / 2, 2.0});
  rig.finish();
  rig.sim.set_pose(other, {rig.sim.pose(rig.robot).x, 2.3, 0.0});
  rig.sim.set_speed(rig.robot, {0.1, 0.0});
  rig.steps(200);
  ASSERT_EQ(rig.sim.collisions().size(), 2u) << "it slid along the wall into the other robot";
  EXPECT_EQ(rig.sim.collisions()[1].with_robot, other);
}

TEST(Collision, WithABallIsToldOfEachTimeThatItIsHit) {
  Simulation sim(room_with({golf(1.5, 2.0)}), {});
  const RobotIndex robot = sim.add_robot({}, {1.0, 2.0, 0.0});
  sim.set_speed(robot, {0.3, 0.0});
  while (sim.collision_count() == 0 && sim.time() < 5.0) sim.step();
  ASSERT_EQ(sim.collisions().size(), 1u);
  EXPECT_EQ(sim.collisions()[0].robot, robot);
  EXPECT_EQ(sim.collisions()[0].with_body, 0u);
  EXPECT_EQ(sim.collisions()[0].with_robot, std::nullopt);
  EXPECT_NEAR(sim.collisions()[0].place.x, 1.5 - 0.02, 1e-6);
  EXPECT_DOUBLE_EQ(sim.collisions()[0].time, sim.time());
  for (int i = 0; i < 300; ++i) sim.step();  // it rolls ahead, slows down, and is hit again
  EXPECT_GT(sim.collision_count(), 1u);
  for (const CollisionEvent& event : sim.collisions()) EXPECT_EQ(event.robot, robot);
}

TEST(Collision, WithAnObstacleOnItsPathIsToldOfWhoeverCame) {
  world::ObjectSpec post = golf(1.0, 2.0);
  post.path = world::Path{0.5, false, {{3.0, 2.0}}};
  Simulation sim(room_with({post}), {});
  const RobotIndex robot = sim.add_robot({}, {2.0, 2.0, 0.0});
  for (int i = 0; i < 500; ++i) sim.step();
  ASSERT_EQ(sim.collisions().size(), 1u);
  EXPECT_EQ(sim.collisions()[0].robot, std::nullopt);
  EXPECT_EQ(sim.collisions()[0].body, 0u);
  EXPECT_EQ(sim.collisions()[0].with_robot, robot);
}

TEST(Collision, TheNewestOfVeryManyAreKeptAndAllAreCounted) {
  world::ObjectSpec ball = golf(0.1, 0.1);
  ball.matter.friction = 0.0;
  ball.matter.restitution = 1.0;
  auto model = std::make_shared<world::WorldModel>(*room(0.2, 0.2));
  model->objects = {ball};
  Simulation sim(model, {});
  std::uint64_t told = 0;
  sim.on_collision([&](const CollisionEvent&) { ++told; });
  sim.world().set_velocity(0, {4.0, 0.0});
  while (told < 2 * kCollisionsKept + 1) sim.step();
  EXPECT_EQ(sim.collision_count(), told);
  EXPECT_EQ(sim.collisions().size(), kCollisionsKept + 1);
  EXPECT_EQ(sim.collisions().back().time, sim.time());
  EXPECT_LT(sim.collisions().front().time, sim.collisions().back().time);
}

}  // namespace
}  // namespace eyebridge::robot
