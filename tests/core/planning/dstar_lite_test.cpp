#include "eyebridge/planning/dstar_lite.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "eyebridge/planning/astar.hpp"
#include "grids.hpp"

namespace eyebridge::planning {
namespace {

using mapping::Cell;

/// Whether both planners say the same of the grid as it is now; counts the paths.
void compare(DStarLite& planner, Vec2 start, Vec2 goal, int& found) {
  const Planned path = planner.plan(start);
  const Planned expected = astar(planner.blocked(), start, goal);
  ASSERT_EQ(path.has_value(), expected.has_value());
  if (!path) {
    EXPECT_EQ(path.error(), expected.error());
    return;
  }
  ++found;
  ASSERT_NEAR(path->length, expected->length, 1e-9);
  EXPECT_EQ(path->points.front(), expected->points.front());
  EXPECT_EQ(path->points.back(), expected->points.back());
  EXPECT_TRUE(test::is_clear(planner.blocked(), path->points));
}

TEST(DStarLite, EqualsAstarAfterEachOfManyRandomChanges) {
  Random random(31);
  int found = 0;
  for (int trial = 0; trial < 50; ++trial) {
    const int side = 4 + static_cast<int>(random.uniform() * 20);
    const BlockedRaster blocked = test::random_grid(side, side, 0.4 * random.uniform(), random);
    const mapping::GridGeometry& grid = blocked.geometry;
    const Vec2 goal = grid.centre_of(test::random_cell(grid, random));
    Cell robot = test::random_cell(grid, random);
    DStarLite planner(blocked, goal);
    for (int change = 0; change < 40; ++change) {
      SCOPED_TRACE(testing::Message() << "trial " << trial << ", change " << change);
      compare(planner, grid.centre_of(robot), goal, found);
      if (HasFatalFailure()) return;
      const int cells = 1 + static_cast<int>(random.uniform() * 5);
      for (int i = 0; i < cells; ++i) {
        planner.set_blocked(test::random_cell(grid, random), random.chance(0.4));
      }
      if (random.chance(0.5)) robot = test::random_cell(grid, random);
    }
  }
  EXPECT_GT(found, 500);
}

TEST(DStarLite, LeadsARobotThatSeesOnlyItsSurroundings) {
  Random random(32);
  int arrived = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const BlockedRaster real = test::random_grid(30, 30, 0.3, random);
    const mapping::GridGeometry& grid = real.geometry;
    const Cell goal = test::random_cell(grid, random);
    Cell robot = test::random_cell(grid, random);
    if (real[robot] != 0 || real[goal] != 0) continue;
    DStarLite planner(BlockedRaster(grid), grid.centre_of(goal));
    int known = 0;
    while (robot != goal) {
      for (int up = -2; up <= 2; ++up) {
        for (int right = -2; right <= 2; ++right) {
          const Cell seen{robot.column + right, robot.row + up};
          if (grid.contains(seen)) planner.set_blocked(seen, real[seen] != 0);
        }
      }
      compare(planner, grid.centre_of(robot), grid.centre_of(goal), known);
      if (HasFatalFailure()) return;
      const Planned path = planner.plan(grid.centre_of(robot));
      if (!path) break;
      const Cell to = grid.cell_at(path->points[1]);
      robot = {robot.column + std::clamp(to.column - robot.column, -1, 1),
               robot.row + std::clamp(to.row - robot.row, -1, 1)};
      ASSERT_EQ(real[robot], 0);
    }
    const bool reachable = astar(real, grid.centre_of(robot), grid.centre_of(goal)).has_value();
    EXPECT_EQ(robot == goal, reachable);
    if (robot == goal) ++arrived;
  }
  EXPECT_GT(arrived, 5);
}

TEST(DStarLite, SearchesLessAfterAChangeNearTheRobotThanFromScratch) {
  const BlockedRaster open({{0, 0}, 1.0, 100, 100});
  const Vec2 goal{95.5, 50.5};
  DStarLite planner(open, goal);
  ASSERT_TRUE(planner.plan({5.5, 50.5}));
  for (int row = 45; row <= 55; ++row) planner.set_blocked({9, row}, true);
  const Planned again = planner.plan({5.5, 50.5});
  DStarLite fresh(planner.blocked(), goal);
  const Planned scratch = fresh.plan({5.5, 50.5});
  ASSERT_TRUE(again && scratch);
  EXPECT_DOUBLE_EQ(again->length, scratch->length);
  EXPECT_LT(again->expanded, scratch->expanded);
}

TEST(DStarLite, SaysWhatIsWrongAndRecovers) {
  DStarLite planner(test::drawn({"..."}), {2.5, 0.5});
  EXPECT_EQ(planner.plan({3.5, 0.5}).error(), NoPath::StartOutside);
  EXPECT_EQ(planner.plan({2.5, 0.5})->length, 0.0);
  planner.set_blocked({1, 0}, true);
  EXPECT_EQ(planner.plan({0.5, 0.5}).error(), NoPath::Unreachable);
  planner.set_blocked({2, 0}, true);
  EXPECT_EQ(planner.plan({0.5, 0.5}).error(), NoPath::GoalBlocked);
  planner.set_blocked({2, 0}, false);
  planner.set_blocked({1, 0}, false);
  EXPECT_EQ(planner.plan({0.5, 0.5})->length, 2.0);
  EXPECT_EQ(DStarLite(test::drawn({"..."}), {9, 9}).plan({0.5, 0.5}).error(), NoPath::GoalOutside);
}

}  // namespace
}  // namespace eyebridge::planning
