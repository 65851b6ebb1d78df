#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "eyebridge/world/world.hpp"
#include "scenes.hpp"

namespace eyebridge::world {
namespace {

constexpr double kProfileStep = 0.01;

ObjectSpec patrol(Path path) {
  ObjectSpec spec;
  spec.kind = ObjectKind::Can;
  spec.pose = {1, 1, 0};
  spec.radius = 0.05;
  spec.path = std::move(path);
  return spec;
}

World world_of(ObjectSpec object) {
  WorldModel model = room(6, 4);
  model.objects.push_back(std::move(object));
  return World(shared(std::move(model)));
}

void pass_time(World& world, double seconds) {
  for (int i = 0; i < std::lround(seconds / kProfileStep); ++i) world.step_objects(kProfileStep);
}

TEST(PathProfile, EachLegHasItsSpeedAndTheLoopItsWayHome) {
  Path path{0.2, true, {{2, 1}, {2, 2}}};
  path.leg_speeds = {0.5, 0.25, 1.0};
  World world = world_of(patrol(path));
  pass_time(world, 1.0);
  EXPECT_NEAR(world.position(0).x, 1.5, 1e-9);
  pass_time(world, 3.0);
  EXPECT_NEAR(world.position(0).y, 1.5, 1e-9);
  pass_time(world, 2.0 + 0.5 * std::sqrt(2.0));
  EXPECT_NEAR(norm(world.position(0) - Vec2{1.5, 1.5}), 0.0, 0.01);
}

TEST(PathProfile, LegsWithoutASpeedHaveThePathsAndTheWayBackThoseOfTheWayThere) {
  Path path{0.5, false, {{2, 1}, {3, 1}}};
  path.leg_speeds = {0.25};
  World world = world_of(patrol(path));
  pass_time(world, 6.0);
  EXPECT_NEAR(world.position(0).x, 3.0, 1e-9);
  pass_time(world, 2.0);
  EXPECT_NEAR(world.position(0).x, 2.0, 1e-9);
  pass_time(world, 2.0);
  EXPECT_NEAR(world.position(0).x, 1.5, 1e-9);
}

TEST(PathProfile, ItStandsAtItsPointsAsLongAsItIsTold) {
  Path path{0.5, true, {{2, 1}, {3, 1}}};
  path.waits = {1.5, 0.0, 0.255};
  World world = world_of(patrol(path));
  pass_time(world, 3.4);
  EXPECT_NEAR(world.position(0).x, 2.0, 1e-9);
  pass_time(world, 0.6);
  EXPECT_NEAR(world.position(0).x, 2.25, 1e-9) << "it left after 3.5 s";
  pass_time(world, 1.5 + 4.0);
  EXPECT_NEAR(world.position(0).x, 1.0, 1e-9);
  pass_time(world, 0.25);
  EXPECT_NEAR(world.position(0).x, 1.0, 1e-9);
  pass_time(world, 0.01);
  EXPECT_NEAR(world.position(0).x, 1.0025, 1e-9) << "the rest of a step is driven";
}

TEST(PathProfile, SpeedGrowsAndShrinksAtTheAccelerationAndItArrivesOnTime) {
  Path path{0.5, true, {{2, 1}}};
  path.acceleration = 0.5;
  path.waits = {1.0};
  World world = world_of(patrol(path));
  double last = 1.0;
  double speed = 0.0;
  double fastest = 0.0;
  int steps = 0;
  while (world.position(0).x < 2.0 - 1e-12 && steps < 1000) {
    world.step_objects(kProfileStep);
    ++steps;
    const double now = (world.position(0).x - last) / kProfileStep;
    // The last step is over before its time is.
    EXPECT_LE(std::fabs(now - speed), 1.6 * 0.5 * kProfileStep) << "in step " << steps;
    fastest = std::max(fastest, now);
    speed = now;
    last = world.position(0).x;
  }
  EXPECT_NEAR(fastest, 0.5, 1e-9);
  // 1 s to gain speed (0.25 m), 1 s at 0.5 m/s, 1 s to brake.
  EXPECT_NEAR(steps * kProfileStep, 3.0, 2 * kProfileStep);
}

TEST(PathProfile, AShortWayIsATriangle) {
  Path path{5.0, false, {{2, 1}}};
  path.acceleration = 1.0;
  World world = world_of(patrol(path));
  pass_time(world, 1.0);
  EXPECT_NEAR(world.position(0).x, 1.5, 0.01);
  pass_time(world, 1.02);
  EXPECT_NEAR(world.position(0).x, 2.0, 1e-3);
}

TEST(PathProfile, ItIsSlowEnoughWhereASlowLegBeginsAndForAShortLegBeforeAWait) {
  Path path{1.0, true, {{3, 1}, {3.05, 1}, {3.05, 2}}};
  path.leg_speeds = {1.0, 1.0, 0.1};
  path.waits = {0.0, 1.0};
  path.acceleration = 0.5;
  World world = world_of(patrol(path));
  double last = world.position(0).x;
  double speed = 0.0;
  for (int i = 0; i < 430; ++i) {
    world.step_objects(kProfileStep);
    const double now = (world.position(0).x - last) / kProfileStep;
    EXPECT_LE(std::fabs(now - speed), 1.6 * 0.5 * kProfileStep) << "in step " << i;
    speed = now;
    last = world.position(0).x;
  }
  EXPECT_NEAR(world.position(0).x, 3.05, 1e-6);
}

TEST(PathProfile, WhoIsPutSomewhereStartsFromStanding) {
  Path path{1.0, false, {{5, 1}}};
  path.acceleration = 0.5;
  World world = world_of(patrol(path));
  pass_time(world, 1.0);  // 0.5 m/s fast by then
  world.set_pose(0, {2, 1, 0});
  pass_time(world, 0.5);
  EXPECT_NEAR(world.position(0).x, 2 + 0.5 * 0.5 * 0.25, 1e-6);
}

TEST(PathProfile, ARobotInTheWayCostsTheSpeed) {
  Path path{0.5, false, {{4, 1}}};
  path.acceleration = 0.2;
  World world = world_of(patrol(path));
  const BodyId robot = world.add_robot({2, 1, 0}, 0.1, 0.1, {});
  pass_time(world, 6.0);
  EXPECT_NEAR(world.position(0).x, 1.85, 1e-6);
  world.set_pose(robot, {2, 3, 0});
  pass_time(world, 0.5);
  EXPECT_NEAR(world.position(0).x, 1.85 + 0.5 * 0.2 * 0.25, 1e-6) << "from standing";
}

TEST(PathProfile, ItYieldsToRobotsThatAreNearAndGoesOnAfter) {
  for (const bool has_profile : {false, true}) {
    Path path{0.5, false, {{4, 1}}};
    if (has_profile) path.leg_speeds = {0.5};
    ObjectSpec object = patrol(path);
    object.yields_within = 0.3;
    World world = world_of(object);
    const BodyId robot = world.add_robot({1.8, 1.15, 0}, 0.1, 0.1, {});
    pass_time(world, 4.0);
    EXPECT_NEAR(norm(world.position(0) - world.position(robot)), 0.45, 0.006);
    EXPECT_TRUE(world.bumps().empty());
    world.set_pose(robot, {5, 3, 0});
    const double before = world.position(0).x;
    pass_time(world, 1.0);
    EXPECT_NEAR(world.position(0).x, before + 0.5, 1e-6);
  }
}

TEST(PathProfile, NumbersThatCannotBeAreRefused) {
  const auto refused = [](auto change) {
    ObjectSpec object = patrol({0.5, false, {{2, 1}}});
    change(object);
    EXPECT_THROW(world_of(object), std::invalid_argument);
  };
  refused([](ObjectSpec& o) { o.path->leg_speeds = {0.5, 0.5}; });
  refused([](ObjectSpec& o) { o.path->leg_speeds = {0.0}; });
  refused([](ObjectSpec& o) { o.path->waits = {-1.0}; });
  refused([](ObjectSpec& o) { o.path->acceleration = std::nan(""); });
  refused([](ObjectSpec& o) { o.yields_within = -0.1; });
  refused([](ObjectSpec& o) { o.reaction.emplace(); });
}

}  // namespace
}  // namespace eyebridge::world
