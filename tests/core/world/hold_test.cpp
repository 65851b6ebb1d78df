// A body that holds another one is remembered as long as it stays where it is.

#include <utility>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/world/world.hpp"
#include "scenes.hpp"

namespace eyebridge::world {
namespace {

constexpr double kHoldStep = 0.01;

/// Two robots of radius 0.1 m in a room of 4 x 2 m; the first drives to the right until the second,
/// at (2, 1), holds it.
class Holding : public ::testing::Test {
 protected:
  Holding() {
    for (int i = 0; i < 100; ++i) told_ += step(0.01);
  }
  /// So many contacts begin when the first robot goes on by `way`.
  std::size_t step(double way) {
    last_ = world_.move(first_, {{way, 0.0}, {}}, kHoldStep);
    world_.step_objects(kHoldStep);
    return world_.bumps().size();
  }

  World world_{shared(room(4, 2))};
  BodyId first_ = world_.add_robot({1.5, 1, 0}, 0.1, 0.1, {});
  BodyId second_ = world_.add_robot({2, 1, 0}, 0.1, 0.1, {});
  MoveResult last_;
  std::size_t told_ = 0;
};

TEST_F(Holding, SaysTheSameEachTimeAndIsToldOfOnce) {
  EXPECT_EQ(told_, 1U);
  const Vec2 held = world_.position(first_);
  EXPECT_NEAR(held.x, 1.8, 2 * kContactGap);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(step(0.01), 0U);
    EXPECT_EQ(last_.fraction, 0.0);
    EXPECT_FALSE(last_.hit_wall);
    EXPECT_EQ(last_.hit_body, second_);
    EXPECT_NEAR(norm(last_.contact - Vec2{1, 0}), 0.0, 1e-12);
    EXPECT_EQ(world_.position(first_), held);
  }
}

TEST_F(Holding, EndsWhenTheOtherOneGoesOn) {
  world_.move(second_, {{0.005, 0.0}, {}}, kHoldStep);
  step(0.01);
  EXPECT_NEAR(last_.fraction, 0.5, 1e-6);
  EXPECT_NEAR(world_.position(first_).x, 1.805, 2 * kContactGap);
}

TEST_F(Holding, IsOfOneMotionOnly) {
  step(-0.01);
  EXPECT_EQ(last_.fraction, 1.0);
  step(0.02);
  EXPECT_NEAR(last_.fraction, 0.5, 1e-6);
}

TEST_F(Holding, EndsWhenTheOtherOneIsTakenAway) {
  world_.remove(second_);
  EXPECT_EQ(step(0.01), 0U);
  EXPECT_EQ(last_.fraction, 1.0);
}

TEST_F(Holding, OfWhoIsPutToTheSamePlaceAgainIsANewOne) {
  world_.set_pose(second_, world_.pose(second_));
  EXPECT_EQ(step(0.01), 1U);
  EXPECT_EQ(last_.hit_body, second_);
  world_.set_pose(first_, world_.pose(first_));
  EXPECT_EQ(step(0.01), 1U);
}

TEST_F(Holding, OfWhoLeftAndCameBackIsANewOne) {
  const Pose there = world_.pose(second_);
  int times = 0;
  for (int i = 0; i < 20; ++i) {
    const double way = 0.01 + 0.003 * i;
    world_.move(second_, {{way, 0.0}, {}}, kHoldStep);
    world_.step_objects(kHoldStep);
    // As near to its place as rounding lets it come, mostly exactly there.
    world_.move(second_, {{there.x - world_.position(second_).x, 0.0}, {}}, kHoldStep);
    world_.step_objects(kHoldStep);
    const std::size_t ran_into_it = world_.bumps().size();
    if (world_.position(second_) != there.position()) continue;
    EXPECT_EQ(ran_into_it + step(0.01), 1U) << i;
    ++times;
  }
  EXPECT_GT(times, 5);
}

TEST_F(Holding, IsAContactOfTheStepAlsoWhenTheOtherOneLeavesInIt) {
  world_.move(first_, {{0.01, 0.0}, {}}, kHoldStep);
  world_.move(second_, {{0.002, 0.0}, {}}, kHoldStep);
  world_.step_objects(kHoldStep);
  EXPECT_EQ(step(0.01), 0U) << "they touched in the step before";
  EXPECT_NEAR(last_.fraction, 0.2, 1e-6);
}

TEST(HoldingByAThing, EndsWhenThatGivesWay) {
  WorldModel model = room(4, 2);
  ObjectSpec can;
  can.kind = ObjectKind::Can;
  can.name = "can";
  can.pose = {2, 1, 0};
  can.radius = 0.05;
  model.objects.push_back(can);
  World world(shared(std::move(model)));
  const BodyId robot = world.add_robot({1.5, 1, 0}, 0.1, 0.1, {});
  const auto drive = [&] {
    const MoveResult result = world.move(robot, {{0.01, 0.0}, {}}, kHoldStep);
    world.step_objects(kHoldStep);
    return result;
  };
  world.set_fixed(0, true);
  for (int i = 0; i < 100; ++i) drive();
  EXPECT_EQ(drive().fraction, 0.0);
  world.set_fixed(0, false);
  EXPECT_FALSE(drive().blocked());
  EXPECT_GT(world.position(world.object_body(0)).x, 2.005);
}

TEST(HoldingAtAWall, EndsTheContactWithTheWall) {
  World world(shared(room(4, 2)));
  const BodyId robot = world.add_robot({0.2, 1, 0}, 0.1, 0.1, {});
  world.add_robot({0.5, 1, 0}, 0.1, 0.1, {});
  const auto go = [&](double way) { return world.move(robot, {{way, 0.0}, {}}, kHoldStep); };
  const auto told = [&] {
    world.step_objects(kHoldStep);
    return world.bumps().size();
  };
  EXPECT_TRUE(go(-0.2).hit_wall);
  EXPECT_EQ(told(), 1U);
  // To the other robot, and held by it, within a step.
  go(0.5);
  EXPECT_EQ(go(0.5).fraction, 0.0);
  EXPECT_EQ(told(), 1U);
  EXPECT_TRUE(go(-0.5).hit_wall);
  EXPECT_EQ(told(), 1U) << "the wall again";
}

TEST(HoldingAtAWall, IsNotTheWalls) {
  World world(shared(room(4, 2)));
  const BodyId robot = world.add_robot({1.5, 0.101, 0}, 0.1, 0.1, {});
  const BodyId other = world.add_robot({2, 0.15, 0}, 0.1, 0.1, {});
  const auto go = [&](BodyId who, double way) {
    return world.move(who, {{way, 0.0}, {}}, kHoldStep);
  };
  for (int i = 0; i < 100; ++i) {
    go(robot, 0.01);
    world.step_objects(kHoldStep);
  }
  EXPECT_EQ(go(robot, 0.01).hit_body, other);
  go(other, 0.5);  // in the same step
  EXPECT_FALSE(go(robot, 0.01).blocked());
}

TEST(HoldingInACrowd, ChangesNothing) {
  // Whoever asks for a motion that is a hair shorter is never held by memory alone.
  const auto run = [](bool remembers) {
    World world(shared(room(1.6, 1.6)));
    std::vector<BodyId> robots;
    for (int row = 0; row < 5; ++row) {
      for (int column = 0; column < 5; ++column) {
        const Pose start{0.3 + 0.25 * column, 0.3 + 0.25 * row, 1.3 * (5 * row + column)};
        robots.push_back(world.add_robot(start, 0.08, 0.1, {}));
      }
    }
    Random random(4);
    std::vector<Vec2> ways(robots.size());
    for (int step = 0; step < 3000; ++step) {
      for (std::size_t i = 0; i < robots.size(); ++i) {
        if (random.uniform() < 0.01) ways[i] = {0.004 * random.uniform() - 0.002, 0.0};
        const double turn = step % 500 < 20 ? 0.02 : 0.0;
        const Vec2 way{remembers ? ways[i].x : ways[i].x * (1.0 - 1e-13 * (step % 2)), 0.0};
        world.move(robots[i], {way, Heading::from_angle(turn)}, kHoldStep);
      }
      world.step_objects(kHoldStep);
    }
    std::vector<Vec2> places;
    for (const BodyId robot : robots) places.push_back(world.position(robot));
    return places;
  };
  const std::vector<Vec2> held = run(true);
  const std::vector<Vec2> asked = run(false);
  for (std::size_t i = 0; i < held.size(); ++i) {
    EXPECT_NEAR(norm(held[i] - asked[i]), 0.0, 1e-6) << i;
  }
}

}  // namespace
}  // namespace eyebridge::world
