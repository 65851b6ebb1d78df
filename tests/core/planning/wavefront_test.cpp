#include "eyebridge/planning/wavefront.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "grids.hpp"

namespace eyebridge::planning {
namespace {

using mapping::Cell;

TEST(Wavefront, EqualsBruteForceInEveryCellAndEveryDescentIsThatLong) {
  Random random(41);
  for (int trial = 0; trial < 200; ++trial) {
    const BlockedRaster blocked =
        test::random_grid(3 + trial % 17, 3 + trial % 13, 0.5 * random.uniform(), random, 0.2);
    const mapping::GridGeometry& grid = blocked.geometry;
    std::vector<Cell> cells;
    std::vector<Vec2> goals;
    for (int i = 0; i <= trial % 3; ++i) {
      cells.push_back(test::random_cell(grid, random));
      goals.push_back(grid.centre_of(cells.back()));
    }
    for (const Neighbours neighbours : {Neighbours::Four, Neighbours::Eight}) {
      const std::vector<double> expected =
          test::brute_force(blocked, cells, neighbours == Neighbours::Eight);
      const DistanceField field = wavefront(blocked, goals, neighbours);
      for (std::size_t i = 0; i < expected.size(); ++i) {
        if (std::isinf(expected[i])) {
          ASSERT_TRUE(std::isinf(field.cells[i])) << trial;
        } else {
          ASSERT_NEAR(field.cells[i], 0.2 * expected[i], 1e-9) << trial;
        }
      }
      const Cell start = test::random_cell(grid, random);
      const Planned path = path_down(blocked, field, grid.centre_of(start), neighbours);
      if (blocked[start] != 0) {
        EXPECT_EQ(path.error(), NoPath::StartBlocked);
      } else if (std::isinf(field[start])) {
        EXPECT_EQ(path.error(), NoPath::Unreachable);
      } else {
        ASSERT_NEAR(path->length, field[start], 1e-9) << trial;
        EXPECT_TRUE(test::is_clear(blocked, path->points));
        EXPECT_EQ(field[grid.cell_at(path->points.back())], 0.0);
      }
    }
  }
}

TEST(Wavefront, NumbersTheCellsOfAMazeFromItsGoal) {
  const BlockedRaster blocked = test::drawn({"....",  //
                                             ".##.",  //
                                             ".#.."});
  const Vec2 goal{2.5, 0.5};
  const DistanceField field = wavefront(blocked, std::vector{goal}, Neighbours::Four);
  const double no = std::numeric_limits<double>::infinity();
  EXPECT_EQ(field.cells, (std::vector<double>{8, no, 0, 1, 7, no, no, 2, 6, 5, 4, 3}));
}

TEST(Wavefront, StartsNoWaveFromGoalsThatCannotBe) {
  const BlockedRaster blocked = test::drawn({"#.."});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vec2> goals{{0.5, 0.5}, {5, 5}, {nan, nan}};
  const DistanceField field = wavefront(blocked, goals);
  for (const double distance : field.cells) EXPECT_TRUE(std::isinf(distance));
  EXPECT_EQ(path_down(blocked, field, {nan, 0.5}).error(), NoPath::StartOutside);
}

}  // namespace
}  // namespace eyebridge::planning
