#include "eyebridge/mapping/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"

namespace eyebridge::mapping {
namespace {

/// Every cell against every occupied one.
float nearest(const Raster<std::uint8_t>& occupied, Cell from) {
  int best = std::numeric_limits<int>::max();
  for (int row = 0; row < occupied.geometry.rows; ++row) {
    for (int column = 0; column < occupied.geometry.columns; ++column) {
      if (occupied[{column, row}] == 0) continue;
      const int dx = column - from.column;
      const int dy = row - from.row;
      best = std::min(best, dx * dx + dy * dy);
    }
  }
  return static_cast<float>(occupied.geometry.resolution * std::sqrt(static_cast<double>(best)));
}

TEST(DistanceField, IsWhatTheNearestOfAllOccupiedCellsGives) {
  Random random(5);
  for (int round = 0; round < 60; ++round) {
    const int columns = 1 + static_cast<int>(random.uniform() * 30);
    const int rows = 1 + static_cast<int>(random.uniform() * 30);
    Raster<std::uint8_t> occupied({{1, 2}, 0.05, columns, rows});
    const double share = random.uniform() * (round % 2 == 0 ? 0.5 : 0.02);
    for (std::uint8_t& cell : occupied.cells) cell = random.chance(share) ? 1 : 0;
    occupied.cells[static_cast<std::size_t>(random.uniform() *
                                            static_cast<double>(occupied.cells.size()))] = 255;
    const Raster<float> field = distance_field(occupied);
    ASSERT_EQ(field.geometry, occupied.geometry);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        ASSERT_EQ((field[{column, row}]), nearest(occupied, {column, row}))
            << "round " << round << ", cell " << column << ", " << row;
      }
    }
  }
}

TEST(DistanceField, IsInfiniteWhereNothingIsOccupied) {
  const Raster<float> field = distance_field(Raster<std::uint8_t>({{0, 0}, 0.1, 4, 3}));
  for (const float distance : field.cells) {
    EXPECT_EQ(distance, std::numeric_limits<float>::infinity());
  }
  EXPECT_TRUE(distance_field(Raster<std::uint8_t>{}).cells.empty());
}

}  // namespace
}  // namespace eyebridge::mapping
