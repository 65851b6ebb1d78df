#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world.hpp"
#include "scenes.hpp"

namespace eyebridge::world {
namespace {

constexpr double kLiveStep = 0.01;

ObjectSpec thing(ObjectKind kind, double x, double y) {
  ObjectSpec spec;
  spec.kind = kind;
  spec.name = kind == ObjectKind::Box ? "box" : "can";
  spec.pose = {x, y, 0};
  spec.radius = 0.05;
  if (kind == ObjectKind::Box) spec.size = {0.2, 0.1};
  return spec;
}

std::uint64_t state_of(const World& world) {
  StateHash hash;
  world.add_to(hash);
  return hash.value();
}

std::string refusal(World& world, const ObjectSpec& spec) {
  const std::uint64_t before = state_of(world);
  try {
    world.add_object(spec);
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(state_of(world), before) << "what is refused leaves nothing behind";
    return error.what();
  }
  return "";
}

/// A room of 4 x 2 m with a can at (1, 1), then a robot of radius 0.1 at (2, 1).
class LiveObjects : public ::testing::Test {
 protected:
  static World make() {
    WorldModel model = room(4, 2);
    model.objects.push_back(thing(ObjectKind::Can, 1, 1));
    return World(shared(std::move(model)));
  }
  [[nodiscard]] double ray(Vec2 from, Vec2 direction) const {
    return world_.cast_ray(from, direction, 20.0, kNoBody);
  }

  World world_ = make();
  BodyId robot_ = world_.add_robot({2, 1, 0}, 0.1, 0.1, {});
};

TEST_F(LiveObjects, OneThatIsAddedIsMetSeenAndCountedAfterTheRobots) {
  EXPECT_NEAR(ray({3, 0.5}, {0, 1}), 1.5, 1e-12);
  const BodyId can = world_.add_object(thing(ObjectKind::Can, 3, 1));
  EXPECT_EQ(can, 2u);
  EXPECT_NEAR(ray({3, 0.5}, {0, 1}), 0.45, 1e-12);
  EXPECT_EQ(world_.object_count(), 2u);
  EXPECT_EQ(world_.object_body(0), 0u);
  EXPECT_EQ(world_.object_body(1), can);
  EXPECT_EQ(world_.object_of(can), 1u);
  EXPECT_EQ(world_.object_of(robot_), std::nullopt);
  EXPECT_EQ(world_.object_of(kNoBody), std::nullopt);
  EXPECT_EQ(world_.shape(can), BodyShape::Can);
  EXPECT_THROW(static_cast<void>(world_.object_body(2)), std::out_of_range);
  ASSERT_EQ(world_.scene(0).bodies.size(), 3u);
  EXPECT_EQ(world_.scene(0).bodies[2].shape, BodyShape::Can);
}

TEST_F(LiveObjects, ARobotPushesWhatCameLaterAndTellsOfIt) {
  const BodyId box = world_.add_object(thing(ObjectKind::Box, 2.25, 1));
  for (int i = 0; i < 20; ++i) world_.move(robot_, {{0.01, 0}, {}}, kLiveStep);
  world_.step_objects(kLiveStep);
  EXPECT_NEAR(world_.position(box).x, 2.4, 1e-6);
  ASSERT_EQ(world_.bumps().size(), 1u);
  EXPECT_EQ(world_.bumps()[0].other, box);
}

TEST_F(LiveObjects, ABallThatCameLaterRolls) {
  const BodyId ball = world_.add_object(thing(ObjectKind::Ball, 3, 1));
  world_.set_velocity(ball, {0, 0.3});
  for (int i = 0; i < 10; ++i) world_.step_objects(kLiveStep);
  EXPECT_NEAR(world_.position(ball).y, 1.0285, 1e-6);
}

TEST_F(LiveObjects, NoneIsAddedWhereSomethingStands) {
  EXPECT_EQ(refusal(world_, thing(ObjectKind::Can, 3.98, 1)),
            "can at (3.980, 1.000) m would stand in a wall");
  EXPECT_EQ(refusal(world_, thing(ObjectKind::Can, 2.1, 1)),
            "can at (2.100, 1.000) m would stand in a robot at (2.000, 1.000) m");
  EXPECT_EQ(refusal(world_, thing(ObjectKind::Box, 1.1, 1)),
            "box at (1.100, 1.000) m would stand in another object at (1.000, 1.000) m");
  EXPECT_EQ(refusal(world_, thing(ObjectKind::Box, 3.92, 1)),
            "box at (3.920, 1.000) m would stand in a wall");
  EXPECT_NE(refusal(world_, thing(ObjectKind::Can, std::nan(""), 1)), "");
  ObjectSpec flat = thing(ObjectKind::Can, 3, 1);
  flat.radius = 0;
  EXPECT_NE(refusal(world_, flat), "");
  EXPECT_EQ(refusal(world_, thing(ObjectKind::Box, 3.88, 1)), "") << "beside the wall";
  EXPECT_EQ(refusal(world_, thing(ObjectKind::Box, 3.88, 1.11)), "") << "beside the other box";
  EXPECT_EQ(world_.body_count(), 4u) << "a refused one takes no id";
}

TEST_F(LiveObjects, RemovedObjectsAreGoneAndStayAway) {
  world_.remove(0);
  EXPECT_FALSE(world_.is_there(0));
  EXPECT_NEAR(ray({0.5, 1}, {1, 0}), 1.4, 1e-12) << "as far as the robot";
  EXPECT_EQ(world_.object_count(), 1u) << "numbers stay";
  EXPECT_FALSE(world_.gives_way(0));
  world_.set_fixed(0, false);
  world_.set_velocity(0, {1, 0});
  world_.step_objects(kLiveStep);
  EXPECT_EQ(world_.position(0), (Vec2{1, 1}));
  EXPECT_NO_THROW(world_.add_object(thing(ObjectKind::Can, 1, 1))) << "its place is free";
  EXPECT_THROW(world_.remove(7), std::out_of_range);
}

TEST_F(LiveObjects, ARemovedBallRollsNoMoreAndARemovedMoverGoesNowhere) {
  const BodyId ball = world_.add_object(thing(ObjectKind::Ball, 3, 1));
  ObjectSpec patrol = thing(ObjectKind::Can, 1, 0.5);
  patrol.path = Path{0.5, true, {{3, 0.5}}};
  const BodyId mover = world_.add_object(patrol);
  world_.set_velocity(ball, {0.5, 0});
  world_.step_objects(kLiveStep);
  EXPECT_NEAR(world_.position(mover).x, 1.005, 1e-12);
  const Vec2 ball_at = world_.position(ball);
  world_.remove(ball);
  world_.remove(mover);
  world_.step_objects(kLiveStep);
  EXPECT_EQ(world_.position(ball), ball_at);
  EXPECT_NEAR(world_.position(mover).x, 1.005, 1e-12);
}

TEST_F(LiveObjects, WhatIsFixedHoldsARobotUntilItIsLoose) {
  world_.set_pose(robot_, {1.5, 1, kPi});
  const auto drive = [&] { return world_.move(robot_, {{0.4, 0}, {}}, kLiveStep); };
  world_.set_fixed(0, true);
  EXPECT_EQ(drive().hit_body, 0u);
  EXPECT_EQ(world_.position(0), (Vec2{1, 1}));
  world_.set_fixed(0, false);
  EXPECT_FALSE(drive().blocked());
  EXPECT_LT(world_.position(0).x, 0.8);
  EXPECT_THROW(world_.set_fixed(robot_, true), std::out_of_range);
}

TEST_F(LiveObjects, AFixedBallStopsAndTakesNoKick) {
  const BodyId ball = world_.add_object(thing(ObjectKind::Ball, 3, 1));
  EXPECT_TRUE(world_.slides(ball));
  world_.set_velocity(ball, {0.5, 0});
  world_.set_fixed(ball, true);
  EXPECT_FALSE(world_.slides(ball));
  EXPECT_EQ(world_.velocity(ball), (Vec2{}));
  world_.set_velocity(ball, {0.5, 0});
  EXPECT_EQ(world_.velocity(ball), (Vec2{}));
}

TEST_F(LiveObjects, WhatWasChangedIsPartOfTheState) {
  const std::uint64_t before = state_of(world_);
  world_.set_fixed(0, true);
  const std::uint64_t fixed = state_of(world_);
  EXPECT_NE(fixed, before);
  world_.set_fixed(0, false);
  EXPECT_EQ(state_of(world_), before);
  world_.set_fixed(world_.add_object(thing(ObjectKind::Can, 1.5, 0.5)), true);
  const std::uint64_t second = state_of(world_);
  world_.set_fixed(0, true);
  EXPECT_NE(state_of(world_), second);
  world_.set_fixed(world_.object_body(world_.object_count() - 1), false);
  EXPECT_NE(state_of(world_), second) << "which of them is fixed counts";
}

TEST_F(LiveObjects, WhatStoodTakesAWayAndWhatMovedStands) {
  const BodyId can = world_.add_object(thing(ObjectKind::Can, 1, 0.5));
  ObjectSpec like = world_.object(can);
  like.path = Path{0.5, false, {{2, 0.5}}};
  world_.change_object(can, like);
  EXPECT_TRUE(world_.moves_by_itself(can));
  EXPECT_FALSE(world_.gives_way(can));
  for (int i = 0; i < 100; ++i) world_.step_objects(kLiveStep);
  EXPECT_NEAR(world_.position(can).x, 1.0 + 100 * kLiveStep * 0.5, 1e-9);
  like.matter.mass = 3;
  world_.change_object(can, like);
  world_.step_objects(kLiveStep);
  EXPECT_NEAR(world_.position(can).x, 1.0 + 101 * kLiveStep * 0.5, 1e-9) << "still on its way";
  like.path.reset();
  world_.change_object(can, like);
  const Vec2 there = world_.position(can);
  world_.step_objects(kLiveStep);
  EXPECT_EQ(world_.position(can), there);
  EXPECT_TRUE(world_.gives_way(can));
  like.path = Path{0.5, true, {{1, 0.5}}};
  world_.change_object(can, like);
  for (int i = 0; i < 1000; ++i) world_.step_objects(kLiveStep);
  EXPECT_GE(world_.position(can).x, 1.0 - 1e-9);
  EXPECT_LE(world_.position(can).x, there.x + 1e-9)
      << "from where it was, not from its first place";
  EXPECT_EQ(world_.object(can).pose.x, world_.position(can).x);
  EXPECT_EQ(world_.object(can).matter.mass, 3);
}

TEST_F(LiveObjects, WhoOnlyYieldsOtherwiseGoesOnWhereItWas) {
  const BodyId can = world_.add_object(thing(ObjectKind::Can, 1, 0.5));
  ObjectSpec like = world_.object(can);
  like.path = Path{1.0, true, {{2, 0.5}, {2, 0.8}}};
  world_.change_object(can, like);
  for (int i = 0; i < 110; ++i) world_.step_objects(kLiveStep);  // on its second leg
  const Vec2 there = world_.position(can);
  ASSERT_GT(there.y, 0.5);
  like.yields_within = 0.01;
  world_.change_object(can, like);
  world_.step_objects(kLiveStep);
  EXPECT_NEAR(world_.position(can).y, there.y + kLiveStep, 1e-9);
  EXPECT_NEAR(world_.position(can).x, 2.0, 1e-9);
}

TEST_F(LiveObjects, FixingWhatMovesByItselfDoesNothing) {
  const BodyId can = world_.add_object(thing(ObjectKind::Can, 1, 0.5));
  ObjectSpec like = world_.object(can);
  like.path = Path{1.0, true, {{2, 0.5}}};
  world_.change_object(can, like);
  const std::uint64_t before = state_of(world_);
  world_.set_fixed(can, true);
  EXPECT_EQ(state_of(world_), before);
  EXPECT_FALSE(world_.object(can).matter.fixed);
}

TEST_F(LiveObjects, WhatIsGivenAFrictionSlides) {
  const BodyId can = world_.add_object(thing(ObjectKind::Can, 1, 0.5));
  ObjectSpec like = world_.object(can);
  like.matter.friction = 0.0;
  world_.change_object(can, like);
  world_.set_velocity(can, {1, 0});
  world_.step_objects(kLiveStep);
  EXPECT_NEAR(world_.position(can).x, 1.0 + kLiveStep, 1e-9);
  like.matter.friction.reset();
  world_.change_object(can, like);
  EXPECT_EQ(world_.velocity(can), (Vec2{}));
}

TEST_F(LiveObjects, AChangeThatCannotBeChangesNothing) {
  const BodyId can = world_.add_object(thing(ObjectKind::Can, 1, 0.5));
  const std::uint64_t before = state_of(world_);
  ObjectSpec like = world_.object(can);
  like.matter.mass = -1;
  EXPECT_THROW(world_.change_object(can, like), std::invalid_argument);
  like = world_.object(can);
  like.path = Path{0.5, true, {{9, 0.5}}};
  EXPECT_THROW(world_.change_object(can, like), std::invalid_argument) << "into a wall";
  like.path = Path{0.5, true, {{1, 0.5}}};
  EXPECT_THROW(world_.change_object(can, like), std::invalid_argument) << "nowhere";
  EXPECT_THROW(world_.change_object(robot_, like), std::out_of_range);
  EXPECT_THROW(static_cast<void>(world_.object(robot_)), std::out_of_range);
  EXPECT_EQ(state_of(world_), before);
}

TEST_F(LiveObjects, AnotherWayIsAnotherState) {
  const BodyId can = world_.add_object(thing(ObjectKind::Can, 1, 0.5));
  const std::uint64_t before = state_of(world_);
  ObjectSpec like = world_.object(can);
  like.reaction = Reaction{Reaction::Kind::Follow, 0.2};
  world_.change_object(can, like);
  const std::uint64_t slow = state_of(world_);
  EXPECT_NE(slow, before);
  like.reaction->speed = 0.3;
  world_.change_object(can, like);
  EXPECT_NE(state_of(world_), slow);
  like.reaction.reset();
  world_.change_object(can, like);
  EXPECT_EQ(state_of(world_), before) << "as it was";
}

TEST_F(LiveObjects, WhatIsNotFiniteOrFarAwayIsRefused) {
  const double infinite = std::numeric_limits<double>::infinity();
  const auto expect_refused = [&](const auto& change) {
    ObjectSpec object = thing(ObjectKind::Ball, 1.5, 0.5);
    change(object);
    EXPECT_THROW(world_.add_object(object), std::invalid_argument);
  };
  expect_refused([&](ObjectSpec& object) { object.matter.mass = infinite; });
  expect_refused([&](ObjectSpec& object) { object.matter.friction = infinite; });
  expect_refused([&](ObjectSpec& object) { object.radius = infinite; });
  expect_refused([&](ObjectSpec& object) { object.height = infinite; });
  expect_refused([&](ObjectSpec& object) { object.pose.x = 1e30; });
  expect_refused([&](ObjectSpec& object) { object.path = Path{0.1, true, {{infinite, 0}}}; });
  expect_refused([&](ObjectSpec& object) { object.path = Path{0.1, true, {{1.5, 0.5}}}; });
  expect_refused([&](ObjectSpec& object) { object.path = Path{0.1, true, {{1.5, -5.0}}}; });
}

TEST(LiveObjectsInACrowd, ChangesAreTheSameInTwoRunsHoweverManyThereAre) {
  const auto run = [] {
    World world(shared(room(6, 6)));
    Random random(5);
    for (int i = 0; i < 400; ++i) {
      const Vec2 p{0.3 + 5.4 * random.uniform(), 0.3 + 5.4 * random.uniform()};
      if (!world.is_free(p, 0.12)) continue;
      const auto kind = static_cast<ObjectKind>(i % 3);
      if (i % 5 == 0) {
        world.add_robot({p.x, p.y, 6 * random.uniform()}, 0.08, 0.1, {});
      } else {
        world.add_object(thing(kind, p.x, p.y));
      }
      if (i % 7 == 0 && world.object_count() > 0) {
        world.remove(world.object_body(static_cast<std::size_t>(i) % world.object_count()));
      }
      for (BodyId id = 0; id < world.body_count(); ++id) {
        if (world.shape(id) == BodyShape::Robot) world.move(id, {{0.01, 0}, {}}, kLiveStep);
      }
      world.step_objects(kLiveStep);
    }
    for (BodyId id = 0; id < world.body_count(); ++id) {
      if (!world.is_there(id)) continue;
      EXPECT_GT(world.position(id).x, world.shape(id) == BodyShape::Polygon ? 0.05 : 0.0499);
    }
    return state_of(world);
  };
  EXPECT_EQ(run(), run());
}

}  // namespace
}  // namespace eyebridge::world
