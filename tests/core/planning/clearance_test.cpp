#include "eyebridge/planning/clearance.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "grids.hpp"

namespace eyebridge::planning {
namespace {

TEST(Clearance, EqualsTheDistanceToTheNearestSquareInEveryCell) {
  Random random(4);
  for (int trial = 0; trial < 300; ++trial) {
    const int columns = 1 + static_cast<int>(random.uniform() * 20);
    const int rows = 1 + static_cast<int>(random.uniform() * 20);
    const BlockedRaster blocked =
        test::random_grid(columns, rows, 0.3 * random.uniform() * random.uniform(), random, 0.05);
    const ClearanceRaster clearance = clearance_of(blocked);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const double wanted =
            test::nearest_square(blocked, blocked.geometry.centre_of({column, row}));
        ASSERT_FLOAT_EQ((clearance[{column, row}]), static_cast<float>(wanted)) << trial;
      }
    }
  }
}

TEST(Clearance, IsNeverOverratedBetweenCentres) {
  Random random(5);
  double worst = 0.0;
  for (int trial = 0; trial < 2000; ++trial) {
    const BlockedRaster blocked = test::random_grid(15, 15, 0.05, random, 0.1);
    const ClearanceRaster clearance = clearance_of(blocked);
    const Vec2 point = blocked.geometry.origin + 1.5 * Vec2{random.uniform(), random.uniform()};
    const double real = test::nearest_square(blocked, point);
    const double said = clearance_at(clearance, point);
    if (!std::isfinite(real)) continue;
    EXPECT_LE(said, real + 1e-6);
    worst = std::max(worst, real - said);
  }
  EXPECT_LT(worst, 0.142);
  EXPECT_GT(worst, 0.01);
  EXPECT_EQ(clearance_at(clearance_of(BlockedRaster({{0, 0}, 1.0, 2, 2})), {2.5, 0.5}), 0.0);
}

TEST(Widened, BlocksJustTheCellsWhoseRobotWouldTouch) {
  const BlockedRaster blocked = test::drawn({".......",  //
                                             ".......",  //
                                             ".......",  //
                                             "...#...",  //
                                             ".......",  //
                                             ".......",  //
                                             "......."});
  const auto rows_of = [&](double radius) { return widened(clearance_of(blocked), radius); };
  EXPECT_EQ(rows_of(0.0), blocked);
  EXPECT_EQ(rows_of(0.5), blocked);
  EXPECT_EQ(rows_of(0.6), test::drawn({".......",  //
                                       ".......",  //
                                       "...#...",  //
                                       "..###..",  //
                                       "...#...",  //
                                       ".......",  //
                                       "......."}));
  EXPECT_EQ(rows_of(1.55), test::drawn({".......",  //
                                        "...#...",  //
                                        "..###..",  //
                                        ".#####.",  //
                                        "..###..",  //
                                        "...#...",  //
                                        "......."}));
}

}  // namespace
}  // namespace eyebridge::planning
