#include "contacts.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "scenes.hpp"
#include "wall_index.hpp"

namespace eyebridge::world {
namespace {

constexpr double kTouchStep = 0.01;

TEST(Contacts, ABookTellsOncePerContact) {
  ContactBook book;
  double apart = 0.0;
  int over = 0;
  const auto end = [&] {
    book.end_step([&](BodyId, BodyId) { return apart; }, [&](BodyId, BodyId) { ++over; });
    return book.begun().size();
  };
  book.note({3, 1, {}});
  EXPECT_EQ(end(), 1u);
  book.note({1, 3, {}});  // the other ran into it
  EXPECT_EQ(end(), 0u);
  apart = 0.5e-3;
  EXPECT_EQ(end(), 0u);
  book.note({3, 1, {}});
  EXPECT_EQ(end(), 0u) << "they were never apart";
  EXPECT_EQ(over, 0);
  apart = 2e-3;
  EXPECT_EQ(end(), 0u);
  EXPECT_EQ(over, 1);
  book.note({3, 1, {}});
  book.note({3, kNoBody, {}});
  EXPECT_EQ(end(), 2u);
  EXPECT_EQ(book.begun()[1].other, kNoBody);
}

TEST(Contacts, AWallThatHeldARobotBeforeIsToldOfAgain) {
  WorldModel model = room(4, 2);
  Wall slanted;
  slanted.a = {3.2, 0.1};
  slanted.b = {3.9, 1.7};
  model.walls.push_back(slanted);
  World world(shared(std::move(model)));
  const BodyId robot = world.add_robot({3.2, 1, 0}, 0.1, 0.1, {});
  const auto go = [&](double way) {
    world.move(robot, {{way, 0.0}, {}}, kTouchStep);
    world.step_objects(kTouchStep);
    return world.bumps().size();
  };
  for (int row = 0; row < 40; ++row) {
    world.set_pose(robot, {3.2, 0.9 + 0.005 * row, 0});
    std::size_t told = 0;
    for (int i = 0; i < 50; ++i) told += go(0.01);
    EXPECT_EQ(told, 1u) << "held all the time";
    const Vec2 held = world.position(robot);
    world.set_pose(robot, world.pose(robot));
    EXPECT_EQ(go(0.01), 1u) << "a person put it there";
    for (int i = 0; i < 20; ++i) {
      // These two numbers are so near that there and back is exact.
      const double way = held.x - (3.2 + 0.003 * i);
      EXPECT_EQ(go(-way), 0u);
      told = go(way);
      EXPECT_NEAR(norm(world.position(robot) - held), 0.0, 1e-12);
      told += go(0.01);
      EXPECT_EQ(told, 1u) << "the same place, but it was " << way << " m away";
    }
  }
}

/// Robots, balls, cans and boxes in a room.
World bustle() {
  WorldModel model = room(1.6, 1.6);
  for (int i = 0; i < 9; ++i) {
    ObjectSpec spec;
    const int row = i / 3;
    spec.kind = static_cast<ObjectKind>(i % 3);
    if (i > 6) spec.kind = ObjectKind::Polygon;
    spec.corners = {{0.04, 0.0}, {-0.03, 0.03}, {-0.03, -0.03}};
    spec.size = {0.08, 0.05};
    spec.pose = {0.3 + 0.45 * (i % 3), 0.4 + 0.4 * row, 0.5 * i};
    if (row == 1) spec.matter.friction = 0.05;
    model.objects.push_back(spec);
  }
  World world(shared(std::move(model)));
  for (int i = 0; i < 6; ++i) world.add_robot({0.2 + 0.22 * i, 0.15, 1.0 * i}, 0.06, 0.1, {});
  return world;
}

TEST(Contacts, EachBeginsWhereTheTwoAreAndOnlyAfterTheyWereApart) {
  World world = bustle();
  const WallIndex walls(world.model().walls);
  const auto is_box = [&](BodyId id) {
    return id < world.object_count() && world.shape(id) == BodyShape::Polygon;
  };
  // Discs only: the distances of boxes are tested where they are made.
  const auto gap = [&](BodyId a, BodyId b) {
    const Vec2 p = world.position(a);
    if (b == kNoBody) return walls.distance(p, 10.0) - world.radius(a);
    return norm(p - world.position(b)) - world.radius(a) - world.radius(b);
  };
  std::map<std::pair<BodyId, BodyId>, bool> apart;  // since the contact was told of
  Random random(17);
  int told = 0;
  int blocked = 0;
  for (int step = 0; step < 4000; ++step) {
    std::vector<std::pair<BodyId, BodyId>> held;
    for (auto robot = static_cast<BodyId>(world.object_count()); robot < world.body_count();
         ++robot) {
      Arc arc{{0.008 * random.uniform(), 0.0}, {}};
      if (random.chance(0.05)) arc = {{-0.01, 0.0}, Heading::from_angle(random.uniform() - 0.5)};
      const MoveResult result = world.move(robot, arc, kTouchStep);
      if (!result.blocked()) continue;
      ++blocked;
      held.emplace_back(robot, result.hit_body);
    }
    world.step_objects(kTouchStep);
    for (const Bump& bump : world.bumps()) {
      const std::pair pair{std::min(bump.body, bump.other), std::max(bump.body, bump.other)};
      const auto known = apart.find(pair);
      ASSERT_TRUE(known == apart.end() || known->second) << "step " << step;
      apart[pair] = false;
      ASSERT_NEAR(norm(bump.place - world.position(bump.body)), world.radius(bump.body), 0.06);
      ++told;
    }
    for (const auto& [a, b] : held) {
      ASSERT_TRUE(apart.contains({std::min(a, b), std::max(a, b)})) << "held, but never told";
    }
    for (auto& [pair, since] : apart) {
      if (is_box(pair.first) || (pair.second != kNoBody && is_box(pair.second)) ||
          gap(pair.first, pair.second) > ContactBook::kReleaseGap) {
        since = true;
      }
    }
  }
  EXPECT_GT(told, 100);
  EXPECT_GT(blocked, told);
}

}  // namespace
}  // namespace eyebridge::world
