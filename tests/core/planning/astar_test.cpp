#include "eyebridge/planning/astar.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "grids.hpp"

namespace eyebridge::planning {
namespace {

using mapping::Cell;
using test::drawn;

TEST(Astar, IsAsShortAsBruteForceOnAThousandRandomGrids) {
  Random random(1);
  int found = 0;
  int unreachable = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const int columns = 2 + static_cast<int>(random.uniform() * 24);
    const int rows = 2 + static_cast<int>(random.uniform() * 24);
    const double density = 0.5 * random.uniform();
    const BlockedRaster blocked = test::random_grid(columns, rows, density, random, 0.25);
    const mapping::GridGeometry& grid = blocked.geometry;
    const Cell start = test::random_cell(grid, random);
    const Cell goal = test::random_cell(grid, random);
    const Planned path = astar(blocked, grid.centre_of(start), grid.centre_of(goal));
    if (blocked[start] != 0 || blocked[goal] != 0) {
      EXPECT_FALSE(path);
      continue;
    }
    const double shortest = test::brute_force(blocked, {goal})[grid.index_of(start)];
    ASSERT_EQ(path.has_value(), std::isfinite(shortest)) << trial;
    if (!path) {
      EXPECT_EQ(path.error(), NoPath::Unreachable);
      ++unreachable;
      continue;
    }
    ++found;
    ASSERT_NEAR(path->length, 0.25 * shortest, 1e-9) << trial;
    EXPECT_EQ(path->points.front(), grid.centre_of(start));
    EXPECT_EQ(path->points.back(), grid.centre_of(goal));
    EXPECT_TRUE(test::is_clear(blocked, path->points)) << trial;
    EXPECT_DOUBLE_EQ(path->length, length_of(path->points));
  }
  EXPECT_GT(found, 300);
  EXPECT_GT(unreachable, 30);
}

TEST(Astar, DoesNotCutCorners) {
  const BlockedRaster blocked = drawn({"...",  //
                                       ".#.",  //
                                       "..."});
  const Planned path = astar(blocked, {0.5, 1.5}, {1.5, 2.5});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->points, (std::vector<Vec2>{{0.5, 1.5}, {0.5, 2.5}, {1.5, 2.5}}));
}

TEST(Astar, ExpandsOnlyTheLineInTheOpen) {
  const BlockedRaster blocked({{0, 0}, 1.0, 200, 200});
  const Planned path = astar(blocked, {10.5, 10.5}, {150.5, 80.5});
  ASSERT_TRUE(path);
  EXPECT_LE(path->expanded, 150U);
  EXPECT_EQ(path->points.size(), 3U);
}

TEST(Astar, StaysWhereItIs) {
  const BlockedRaster blocked({{0, 0}, 0.5, 3, 3});
  const Planned path = astar(blocked, {0.7, 0.7}, {0.9, 0.6});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->points, (std::vector<Vec2>{{0.75, 0.75}}));
  EXPECT_EQ(path->length, 0.0);
}

TEST(Astar, SaysWhatIsWrongWithTheEnds) {
  const BlockedRaster blocked = drawn({"..#",  //
                                       "..."});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double far = std::numeric_limits<double>::max();
  EXPECT_EQ(astar(blocked, {-0.1, 0.5}, {0.5, 0.5}).error(), NoPath::StartOutside);
  EXPECT_EQ(astar(blocked, {nan, 0.5}, {0.5, 0.5}).error(), NoPath::StartOutside);
  EXPECT_EQ(astar(blocked, {2.5, 1.5}, {0.5, 0.5}).error(), NoPath::StartBlocked);
  EXPECT_EQ(astar(blocked, {0.5, 0.5}, {3.0, 0.5}).error(), NoPath::GoalOutside);
  EXPECT_EQ(astar(blocked, {0.5, 0.5}, {0.5, -far}).error(), NoPath::GoalOutside);
  EXPECT_EQ(astar(blocked, {0.5, 0.5}, {2.5, 1.5}).error(), NoPath::GoalBlocked);
  EXPECT_EQ(astar({}, {0.5, 0.5}, {0.5, 0.5}).error(), NoPath::StartOutside);
}

TEST(Astar, GivesTheSamePathEachTime) {
  Random random(2);
  const BlockedRaster blocked = test::random_grid(60, 60, 0.2, random);
  const Vec2 start = blocked.geometry.centre_of({2, 3});
  const Vec2 goal = blocked.geometry.centre_of({55, 57});
  const Planned first = astar(blocked, start, goal);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->points, astar(blocked, start, goal)->points);
}

}  // namespace
}  // namespace eyebridge::planning
