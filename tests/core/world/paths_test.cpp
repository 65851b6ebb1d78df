#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world.hpp"
#include "scenes.hpp"

namespace eyebridge::world {
namespace {

constexpr double kPathStep = 0.01;

ObjectSpec post(double x, double y, Path path) {
  ObjectSpec spec;
  spec.kind = ObjectKind::Can;
  spec.pose = {x, y, 0.4};
  spec.radius = 0.05;
  spec.path = std::move(path);
  return spec;
}

World world_of_movers(std::vector<ObjectSpec> objects) {
  WorldModel model = room(4, 2);
  model.objects = std::move(objects);
  return World(shared(std::move(model)));
}

void pass(World& world, double seconds) {
  for (int i = 0; i < std::lround(seconds / kPathStep); ++i) world.step_objects(kPathStep);
}

TEST(Paths, ALoopGoesRoundAtItsSpeed) {
  World world = world_of_movers({post(1, 0.5, {0.2, true, {{2, 0.5}, {2, 1.5}, {1, 1.5}}})});
  pass(world, 2.5);
  EXPECT_NEAR(norm(world.position(0) - Vec2{1.5, 0.5}), 0.0, 1e-9);
  pass(world, 5.0);  // round the corner, within a step too
  EXPECT_NEAR(norm(world.position(0) - Vec2{2, 1}), 0.0, 1e-9);
  pass(world, 12.5);
  EXPECT_NEAR(norm(world.position(0) - Vec2{1, 0.5}), 0.0, 1e-9) << "4 m, once round";
  EXPECT_NEAR(world.heading(0).angle(), 0.4, 1e-12) << "it keeps its heading";
}

TEST(Paths, ThereAndBackReturnsAsItWent) {
  World world = world_of_movers({post(1, 0.5, {0.5, false, {{2, 0.5}, {2, 1.5}}})});
  pass(world, 4.0);
  EXPECT_NEAR(norm(world.position(0) - Vec2{2, 1.5}), 0.0, 1e-9);
  pass(world, 1.0);
  EXPECT_NEAR(norm(world.position(0) - Vec2{2, 1.0}), 0.0, 1e-9);
  pass(world, 3.0);
  EXPECT_NEAR(norm(world.position(0) - Vec2{1, 0.5}), 0.0, 1e-9);
  pass(world, 8.0);
  EXPECT_NEAR(norm(world.position(0) - Vec2{1, 0.5}), 0.0, 1e-9) << "and again";
}

TEST(Paths, SeveralPointsWithinOneStepAreAllPassed) {
  World world =
      world_of_movers({post(1, 1, {1.0, true, {{1.001, 1}, {1.001, 1.002}, {1, 1.002}}})});
  pass(world, 0.6);  // a hundred times round 6 mm
  EXPECT_NEAR(norm(world.position(0) - Vec2{1, 1}), 0.0, 1e-9);
}

TEST(Paths, ARobotInTheWayMakesItWaitAndThenItGoesOn) {
  World world = world_of_movers({post(1, 1, {0.5, false, {{3, 1}}})});
  const BodyId robot = world.add_robot({2, 1, 0}, 0.1, 0.1, {});
  pass(world, 10.0);
  EXPECT_NEAR(world.position(0).x, 2 - 0.1 - 0.05, 1e-6);
  EXPECT_EQ(world.position(robot), (Vec2{2, 1})) << "it is not pushed";
  world.set_pose(robot, {2, 1.5, 0});
  pass(world, 2.0);
  EXPECT_NEAR(world.position(0).x, 2.85, 1e-6);
}

TEST(Paths, RobotsStopAtItAndDoNotPushIt) {
  World world = world_of_movers({post(2, 1, {0.001, false, {{2, 1.5}}})});
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  MoveResult result;
  for (int i = 0; i < 100; ++i) result = world.move(robot, {{0.01, 0}, {}}, kPathStep);
  EXPECT_EQ(result.hit_body, 0u);
  EXPECT_EQ(world.position(0), (Vec2{2, 1}));
}

TEST(Paths, ItPushesWhatGivesWay) {
  ObjectSpec box;
  box.kind = ObjectKind::Box;
  box.size = {0.2, 0.2};
  box.pose = {1.5, 1, 0};
  ObjectSpec mover = box;
  mover.pose = {1, 1.02, 0};
  mover.path = Path{0.5, false, {{2, 1.02}}};
  World world = world_of_movers({box, mover});
  pass(world, 2.0);
  EXPECT_NEAR(world.position(1).x, 2.0, 1e-9);
  EXPECT_NEAR(world.position(0).x, 2.2, 1e-6);
  EXPECT_EQ(world.position(0).y, 1.0);
}

TEST(Paths, ItHeadsForItsPointFromWhereAPersonPutsIt) {
  World world = world_of_movers({post(1, 1, {0.5, true, {{3, 1}}})});
  pass(world, 1.0);
  world.set_pose(0, {3, 0.5, 0});
  pass(world, 0.5);
  EXPECT_NEAR(norm(world.position(0) - Vec2{3, 0.75}), 0.0, 1e-9);
}

TEST(Paths, AWallOnTheWayIsFoundForDiscsAndBoxes) {
  const WorldModel model = room(4, 2);
  const auto wall = [&](const ObjectSpec& object) { return wall_on_path(model, object); };
  EXPECT_EQ(wall(post(1, 1, {1, true, {{3, 1}, {3, 1.9}}})), std::nullopt);
  EXPECT_EQ(wall(post(1, 1, {1, true, {{3, 1}, {3, 1.96}}})), 2u);
  ObjectSpec box = post(1, 1, {1, false, {{0.24, 1}}});
  box.kind = ObjectKind::Box;
  box.pose.theta = 0;
  box.size = {0.4, 0.1};
  EXPECT_EQ(wall(box), std::nullopt);
  box.pose.theta = 0.5;
  EXPECT_EQ(wall(box), std::nullopt);
  box.path->points = {{0.19, 1}};
  EXPECT_EQ(wall(box), 3u);
}

TEST(Paths, WhereItHeadsForIsPartOfTheState) {
  const auto hash = [](std::optional<Vec2> first) {
    Path path{0.5, true, {{3, 1}}};
    if (first) path.points.insert(path.points.begin(), *first);
    World world = world_of_movers({post(1, 1, path)});
    StateHash state;
    world.set_pose(0, {1.2, 1, 0});
    pass(world, 0.1);
    world.set_pose(0, {1.2, 1, 0});
    world.add_to(state);
    return state.value();
  };
  EXPECT_NE(hash(std::nullopt), hash(Vec2{1.21, 1}));
}

}  // namespace
}  // namespace eyebridge::world
