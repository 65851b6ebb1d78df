#include "eyebridge/planning/potential_field.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "grids.hpp"

namespace eyebridge::planning {
namespace {

BlockedRaster open_room() { return BlockedRaster({{0, 0}, 0.05, 80, 80}); }

void block(BlockedRaster& blocked, Vec2 low, Vec2 high) {
  const mapping::Cell from = blocked.geometry.cell_at(low);
  const mapping::Cell to = blocked.geometry.cell_at(high);
  for (int row = from.row; row < to.row; ++row) {
    for (int column = from.column; column < to.column; ++column) blocked[{column, row}] = 1;
  }
}

Planned follow(const BlockedRaster& blocked, Vec2 start, Vec2 goal,
               const PotentialSettings& settings = {}) {
  return follow_potential(blocked, clearance_of(blocked), start, goal, settings);
}

TEST(PotentialField, GoesStraightInTheOpen) {
  const Planned path = follow(open_room(), {0.5, 0.7}, {3.3, 3.1});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->points.back(), (Vec2{3.3, 3.1}));
  EXPECT_NEAR(path->length, norm(Vec2{2.8, 2.4}), 1e-3);
}

TEST(PotentialField, GoesAroundARoundObstacleBesideTheLine) {
  BlockedRaster blocked = open_room();
  for (int row = 0; row < 80; ++row) {
    for (int column = 0; column < 80; ++column) {
      const Vec2 away = blocked.geometry.centre_of({column, row}) - Vec2{2.0, 1.9};
      if (norm(away) < 0.25) blocked[{column, row}] = 1;
    }
  }
  const Vec2 start{0.5, 2.0};
  const Vec2 goal{3.5, 2.0};
  ASSERT_FALSE(test::is_clear(blocked, start, goal));
  const Planned path = follow(blocked, start, goal);
  ASSERT_TRUE(path);
  EXPECT_TRUE(test::is_clear(blocked, path->points));
  const ClearanceRaster clearance = clearance_of(blocked);
  for (const Vec2 point : path->points) EXPECT_GT(clearance_at(clearance, point), 0.05);
}

TEST(PotentialField, PassesBetweenTwoWalls) {
  BlockedRaster blocked = open_room();
  block(blocked, {1.5, 0.0}, {2.5, 1.63});
  block(blocked, {1.5, 2.38}, {2.5, 4.0});
  const Planned path = follow(blocked, {0.5, 1.8}, {3.5, 2.1});
  ASSERT_TRUE(path) << to_text(path.error());
  EXPECT_TRUE(test::is_clear(blocked, path->points));
}

TEST(PotentialField, AdmitsThatAPocketHoldsIt) {
  BlockedRaster blocked = open_room();
  block(blocked, {2.0, 1.0}, {2.2, 3.0});
  block(blocked, {1.0, 1.0}, {2.0, 1.2});
  block(blocked, {1.0, 2.8}, {2.0, 3.0});
  EXPECT_EQ(follow(blocked, {0.5, 2.0}, {3.5, 2.0}).error(), NoPath::LocalMinimum);
}

TEST(PotentialField, AdmitsThatObstaclesPushItFromTheGoal) {
  BlockedRaster blocked = open_room();
  block(blocked, {3.0, 0.0}, {3.2, 4.0});
  PotentialSettings settings;
  settings.repulsion = 1.0;
  EXPECT_EQ(follow(blocked, {0.5, 2.0}, {2.92, 2.0}, settings).error(), NoPath::LocalMinimum);
}

TEST(PotentialField, NeverPassesThroughBlockedCellsWhateverTheSettings) {
  Random random(61);
  int arrived = 0;
  int stuck = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const BlockedRaster blocked = test::random_grid(60, 60, 0.02, random, 0.05);
    PotentialSettings settings;
    settings.repulsion = 0.05 * random.uniform();
    settings.reach = 0.05 + 0.3 * random.uniform();
    const Vec2 start = blocked.geometry.centre_of(test::random_cell(blocked.geometry, random));
    const Vec2 goal = blocked.geometry.centre_of(test::random_cell(blocked.geometry, random));
    const Planned path = follow(blocked, start, goal, settings);
    if (path) {
      ++arrived;
      EXPECT_TRUE(test::is_clear(blocked, path->points)) << trial;
      EXPECT_GE(path->length, norm(goal - start) - 1e-9);
    } else if (path.error() == NoPath::LocalMinimum) {
      ++stuck;
    }
  }
  EXPECT_GT(arrived, 20);
  EXPECT_GT(stuck, 20);
}

TEST(PotentialField, RefusesSettingsOutOfRange) {
  PotentialSettings settings;
  settings.reach = 0.0;
  EXPECT_THROW(follow(open_room(), {1, 1}, {2, 2}, settings), std::invalid_argument);
  settings = {};
  settings.repulsion = NAN;
  EXPECT_THROW(follow(open_room(), {1, 1}, {2, 2}, settings), std::invalid_argument);
  settings = {};
  settings.steps = 10;
  EXPECT_EQ(follow(open_room(), {1, 1}, {3, 3}, settings).error(), NoPath::BudgetSpent);
}

}  // namespace
}  // namespace eyebridge::planning
