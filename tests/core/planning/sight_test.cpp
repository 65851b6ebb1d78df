#include "eyebridge/planning/sight.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "grids.hpp"

namespace eyebridge::planning {
namespace {

using mapping::Cell;
using test::drawn;

TEST(FreeLine, NeedsBothCellsBesideACorner) {
  EXPECT_FALSE(is_free_line(drawn({"#.", ".."}), Cell{0, 0}, Cell{1, 1}));
  EXPECT_FALSE(is_free_line(drawn({"..", ".#"}), Cell{0, 0}, Cell{1, 1}));
  EXPECT_TRUE(is_free_line(drawn({"..", ".."}), Cell{0, 0}, Cell{1, 1}));
  EXPECT_FALSE(is_free_line(drawn({"#.", ".."}), Vec2{0.5, 0.5}, Vec2{1.5, 1.5}));
}

// The corner belongs to the line, which sampling need not meet: where it says free, and the lines
// say no, a cell is touched in one point only.
TEST(FreeLine, AgreesWithFineSampling) {
  Random random(3);
  int free = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const BlockedRaster blocked = test::random_grid(12, 9, 0.12, random, 0.5);
    const mapping::GridGeometry& grid = blocked.geometry;
    const Cell a = test::random_cell(grid, random);
    const Cell b = test::random_cell(grid, random);
    const bool line = is_free_line(blocked, a, b);
    EXPECT_EQ(line, is_free_line(blocked, b, a));
    if (line) {
      EXPECT_TRUE(test::is_clear(blocked, grid.centre_of(a), grid.centre_of(b)));
    }
    const auto somewhere = [&] {
      return grid.origin + Vec2{6.0 * random.uniform(), 4.5 * random.uniform()};
    };
    const Vec2 from = somewhere();
    const Vec2 to = somewhere();
    const bool clear = is_free_line(blocked, from, to);
    // Sampled each thousandth of a cell, it may miss a corner cut by less.
    if (clear) {
      EXPECT_TRUE(test::is_clear(blocked, from, to));
      ++free;
    } else {
      const Vec2 off{4e-3, 4e-3};
      const Vec2 across{4e-3, -4e-3};
      EXPECT_FALSE(test::is_clear(blocked, from, to) &&
                   test::is_clear(blocked, from + off, to + off) &&
                   test::is_clear(blocked, from - off, to - off) &&
                   test::is_clear(blocked, from + across, to + across) &&
                   test::is_clear(blocked, from - across, to - across))
          << trial;
    }
  }
  EXPECT_GT(free, 200);
  EXPECT_LT(free, 1800);
}

TEST(FreeLine, EndsAtTheEdgeOfTheGrid) {
  const BlockedRaster blocked = drawn({"...", "..."});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(is_free_line(blocked, Vec2{0.0, 0.0}, Vec2{2.99, 1.99}));
  EXPECT_FALSE(is_free_line(blocked, Vec2{0.0, 0.0}, Vec2{3.0, 1.0}));
  EXPECT_FALSE(is_free_line(blocked, Vec2{-0.1, 0.0}, Vec2{1.0, 1.0}));
  EXPECT_FALSE(is_free_line(blocked, Vec2{1.0, 1.0}, Vec2{nan, 1.0}));
}

TEST(Shortened, PullsAPathStraightAndKeepsItsEnds) {
  const BlockedRaster blocked = drawn({".....",  //
                                       ".....",  //
                                       "..#..",  //
                                       "....."});
  Path path;
  path.points = {{0.5, 0.5}, {0.5, 1.5}, {1.5, 2.5}, {2.5, 2.5}, {4.5, 2.5}, {4.5, 3.5}};
  path.length = length_of(path.points);
  path.expanded = 7;
  const Path shorter = shortened(blocked, path);
  EXPECT_EQ(shorter.points, (std::vector<Vec2>{{0.5, 0.5}, {1.5, 2.5}, {4.5, 3.5}}));
  EXPECT_DOUBLE_EQ(shorter.length, std::sqrt(5.0) + std::sqrt(10.0));
  EXPECT_EQ(shorter.expanded, 7U);
  EXPECT_TRUE(test::is_clear(blocked, shorter.points));
}

TEST(FarthestInSight, StopsAtTheCornerThatHidesTheRest) {
  const BlockedRaster blocked = drawn({"....",  //
                                       ".##.",  //
                                       "...."});
  PathProgress progress({{3.5, 0.5}, {0.5, 0.5}, {0.5, 2.5}, {3.5, 2.5}});
  const Vec2 robot{1.5, 0.5};
  progress.advance(robot, 9.0);
  EXPECT_EQ(farthest_in_sight(blocked, progress, robot, 0.75), (Vec2{0.75, 0.5}));
  // Of places a cell apart, from the farthest: (0.5, 2.25) and so on; the first in sight.
  EXPECT_EQ(farthest_in_sight(blocked, progress, robot, 2.75), (Vec2{0.5, 1.25}));
  EXPECT_EQ(farthest_in_sight(blocked, progress, {2.5, 1.5}, 2.75), (Vec2{0.5, 2.25}));
}

}  // namespace
}  // namespace eyebridge::planning
