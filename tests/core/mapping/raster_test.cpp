#include "eyebridge/mapping/raster.hpp"

#include <gtest/gtest.h>

namespace eyebridge::mapping {
namespace {

TEST(GridGeometry, CoversAFloorByWholeCells) {
  const GridGeometry even = GridGeometry::covering({0, 0}, 2.0, 1.0, 0.05);
  EXPECT_EQ(even.columns, 40);
  EXPECT_EQ(even.rows, 20);
  const GridGeometry odd = GridGeometry::covering({0, 0}, 2.01, 1.0, 0.05);
  EXPECT_EQ(odd.columns, 41);
}

TEST(GridGeometry, FindsTheCellOfAPointAndItsCentre) {
  const GridGeometry grid{{-1.0, 2.0}, 0.5, 4, 4};
  EXPECT_EQ(grid.cell_at({-0.6, 3.2}), (Cell{0, 2}));
  EXPECT_EQ(grid.centre_of({0, 2}), (Vec2{-0.75, 3.25}));
  EXPECT_EQ(grid.cell_at({-1.1, 2.0}), (Cell{-1, 0}));
  EXPECT_FALSE(grid.contains({-1, 0}));
  EXPECT_TRUE(grid.contains({3, 3}));
  EXPECT_FALSE(grid.contains({3, 4}));
}

TEST(GridGeometry, HasNoCellsUntilItIsTold) {
  const GridGeometry grid;
  EXPECT_EQ(grid.columns, 0);
  EXPECT_EQ(grid.rows, 0);
  EXPECT_EQ(grid.size(), 0U);
  EXPECT_FALSE(grid.contains({0, 0}));
}

TEST(Raster, KeepsRowsFromTheLowerLeft) {
  Raster<int> raster({{0, 0}, 1.0, 3, 2}, 7);
  raster[{2, 1}] = 9;
  EXPECT_EQ(raster.cells, (std::vector<int>{7, 7, 7, 7, 7, 9}));
}

}  // namespace
}  // namespace eyebridge::mapping
