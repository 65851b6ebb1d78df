#include "eyebridge/planning/rrt_star.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "eyebridge/planning/sight.hpp"
#include "eyebridge/planning/theta_star.hpp"
#include "grids.hpp"

namespace eyebridge::planning {
namespace {

/// 4 x 4 m; a wall from x = 1.9 to 2.1 m leaves 0.5 m open at the top.
BlockedRaster walled_room() {
  BlockedRaster blocked({{0, 0}, 0.1, 40, 40});
  for (int row = 0; row < 35; ++row) blocked[{19, row}] = blocked[{20, row}] = 1;
  return blocked;
}

const Vec2 kStart{0.53, 0.51};
const Vec2 kGoal{3.47, 0.52};
/// Around both corners of the wall: nothing is shorter.
const double kShortest = norm(Vec2{1.9, 3.5} - kStart) + 0.2 + norm(kGoal - Vec2{2.1, 3.5});

TEST(RrtStar, IsWithinATwelfthOfTheShortestWayForTwentySeeds) {
  const BlockedRaster blocked = walled_room();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const Planned path = rrt_star(blocked, kStart, kGoal, random);
    ASSERT_TRUE(path) << seed;
    EXPECT_TRUE(test::is_clear(blocked, path->points)) << seed;
    EXPECT_EQ(path->points.front(), kStart);
    EXPECT_EQ(path->points.back(), kGoal);
    EXPECT_DOUBLE_EQ(path->length, length_of(path->points));
    EXPECT_GE(path->length, kShortest);
    EXPECT_LE(path->length, 1.083 * kShortest) << seed;
    const Path shorter = shortened(blocked, *path);
    EXPECT_LE(shorter.length, path->length);
    EXPECT_LE(shorter.length, 1.05 * kShortest) << seed;
    EXPECT_TRUE(test::is_clear(blocked, shorter.points)) << seed;
  }
}

TEST(RrtStar, ComesNearerToTheShortestWithMoreSamples) {
  const BlockedRaster blocked = walled_room();
  double excess[2] = {};
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    for (int i = 0; i < 2; ++i) {
      Random random(seed);
      RrtStarSettings settings;
      settings.samples = i == 0 ? 1000 : 8000;
      const Planned path = rrt_star(blocked, kStart, kGoal, random, settings);
      ASSERT_TRUE(path) << seed;
      excess[i] += path->length - kShortest;
    }
  }
  EXPECT_LT(excess[1], 0.6 * excess[0]);
}

TEST(RrtStar, MissesBlockedCellsOfRandomGrids) {
  Random random(51);
  int found = 0;
  for (int trial = 0; trial < 50; ++trial) {
    const BlockedRaster blocked = test::random_grid(20, 20, 0.15, random, 0.1);
    const Vec2 start = blocked.geometry.centre_of({1, 1});
    const Vec2 goal = blocked.geometry.centre_of({18, 17});
    RrtStarSettings settings;
    settings.samples = 1200;
    settings.step = 0.3;
    const Planned path = rrt_star(blocked, start, goal, random, settings);
    const Planned exists = theta_star(blocked, start, goal);
    if (!exists) {
      EXPECT_FALSE(path);
      continue;
    }
    if (!path) {
      EXPECT_EQ(path.error(), NoPath::BudgetSpent);
      continue;
    }
    ++found;
    EXPECT_TRUE(test::is_clear(blocked, path->points)) << trial;
    EXPECT_GE(path->length, norm(goal - start));
  }
  EXPECT_GT(found, 25);
}

TEST(RrtStar, GivesTheSamePathForTheSameSeed) {
  const BlockedRaster blocked = walled_room();
  Random one(7);
  Random two(7);
  EXPECT_EQ(rrt_star(blocked, kStart, kGoal, one)->points,
            rrt_star(blocked, kStart, kGoal, two)->points);
}

TEST(RrtStar, SaysWhatIsWrong) {
  Random random(1);
  BlockedRaster closed = walled_room();
  for (int row = 0; row < 40; ++row) closed[{19, row}] = 1;
  EXPECT_EQ(rrt_star(closed, kStart, kGoal, random).error(), NoPath::BudgetSpent);
  EXPECT_EQ(rrt_star(closed, kStart, {1.95, 0.5}, random).error(), NoPath::GoalBlocked);
  EXPECT_THROW(rrt_star(closed, kStart, kGoal, random, {0, 0.5, 0.1}), std::invalid_argument);
  EXPECT_THROW(rrt_star(closed, kStart, kGoal, random, {10, NAN, 0.1}), std::invalid_argument);
  EXPECT_THROW(rrt_star(closed, kStart, kGoal, random, {10, 0.5, 0.0}), std::invalid_argument);
}

TEST(RrtStar, EndsWhereItStartsIfThatIsTheGoal) {
  Random random(1);
  const Planned path = rrt_star(walled_room(), kStart, kStart, random);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->points, std::vector<Vec2>{kStart});
  EXPECT_EQ(path->length, 0.0);
}

}  // namespace
}  // namespace eyebridge::planning
