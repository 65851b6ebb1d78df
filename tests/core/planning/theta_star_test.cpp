#include "eyebridge/planning/theta_star.hpp"

#include <gtest/gtest.h>

#include "eyebridge/planning/astar.hpp"
#include "grids.hpp"

namespace eyebridge::planning {
namespace {

TEST(ThetaStar, IsNeverLongerThanAstarAndMissesAllBlockedCells) {
  Random random(21);
  int shorter = 0;
  int found = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const int side = 3 + static_cast<int>(random.uniform() * 30);
    const BlockedRaster blocked =
        test::random_grid(side, side, 0.45 * random.uniform(), random, 0.5);
    const Vec2 start = blocked.geometry.centre_of(test::random_cell(blocked.geometry, random));
    const Vec2 goal = blocked.geometry.centre_of(test::random_cell(blocked.geometry, random));
    const Planned grid_path = astar(blocked, start, goal);
    const Planned path = theta_star(blocked, start, goal);
    ASSERT_EQ(path.has_value(), grid_path.has_value()) << trial;
    if (!path) {
      EXPECT_EQ(path.error(), grid_path.error());
      continue;
    }
    ++found;
    ASSERT_LE(path->length, grid_path->length + 1e-6) << trial;
    EXPECT_GE(path->length, norm(goal - start) - 1e-9);
    // A line in sight passes cells that share edges: walking those is sqrt(2) longer at most.
    EXPECT_LE(grid_path->length, std::sqrt(2.0) * path->length + 1e-6) << trial;
    EXPECT_TRUE(test::is_clear(blocked, path->points)) << trial;
    if (path->length < grid_path->length - 1e-6) ++shorter;
  }
  EXPECT_GT(found, 300);
  EXPECT_GT(shorter, found / 3);
}

TEST(ThetaStar, IsStraightWhereItSeesTheGoal) {
  const BlockedRaster blocked({{0, 0}, 0.1, 50, 50});
  const Vec2 start = blocked.geometry.centre_of({3, 4});
  const Vec2 goal = blocked.geometry.centre_of({40, 23});
  const Planned path = theta_star(blocked, start, goal);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->points, (std::vector<Vec2>{start, goal}));
  EXPECT_EQ(path->length, norm(goal - start));
}

TEST(ThetaStar, TurnsOnceAboveAThinWall) {
  const BlockedRaster blocked = test::drawn({".......",  //
                                             ".......",  //
                                             "...#...",  //
                                             "...#..."});
  const Planned path = theta_star(blocked, {0.5, 0.5}, {6.5, 0.5});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->points, (std::vector<Vec2>{{0.5, 0.5}, {3.5, 2.5}, {6.5, 0.5}}));
}

TEST(ThetaStar, SaysWhyThereIsNoPath) {
  const BlockedRaster blocked = test::drawn({".#.", ".#."});
  EXPECT_EQ(theta_star(blocked, {0.5, 0.5}, {2.5, 0.5}).error(), NoPath::Unreachable);
  EXPECT_EQ(theta_star(blocked, {0.5, 0.5}, {1.5, 0.5}).error(), NoPath::GoalBlocked);
  EXPECT_EQ(theta_star(blocked, {0.5, 0.5}, {0.5, 0.5})->points.size(), 1U);
}

}  // namespace
}  // namespace eyebridge::planning
