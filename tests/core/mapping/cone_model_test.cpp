#include "eyebridge/mapping/cone_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "bad_numbers.hpp"

namespace eyebridge::mapping {
namespace {

ConeModel sonar(double width_deg = 30, double sigma = 0.01) {
  ConeModel model;
  model.beam.max_range = 2.0;
  model.beam.sigma = sigma;
  model.beam_width = deg_to_rad(width_deg);
  return model;
}

OccupancyGrid grid_of_cells(double resolution = 0.05) {
  return OccupancyGrid(GridGeometry::covering({-0.5, -1.5}, 3.0, 3.0, resolution));
}

TEST(ConeModel, WeighsBearingsAsMoravecAndElfesDo) {
  const ConeModel model = sonar(30);
  EXPECT_EQ(model.weight(0.0), 1.0);
  EXPECT_NEAR(model.weight(deg_to_rad(7.5)), 0.75, 1e-12);
  EXPECT_NEAR(model.weight(deg_to_rad(-7.5)), 0.75, 1e-12);
  EXPECT_NEAR(model.weight(deg_to_rad(15)), 0.0, 1e-12);
  EXPECT_EQ(model.weight(deg_to_rad(40)), 0.0);
}

TEST(ConeModel, IsFreeInsideOccupiedOnTheArcAndUnknownBeyond) {
  OccupancyGrid grid = grid_of_cells();
  ASSERT_TRUE(insert_cone(grid, sonar(), {0, 0, 0}, 1.0));
  const GridGeometry& g = grid.geometry();
  int free = 0;
  int occupied = 0;
  for (int row = 0; row < g.rows; ++row) {
    for (int column = 0; column < g.columns; ++column) {
      const float value = grid.log_odds({column, row});
      if (std::abs(value) < 1e-3F) continue;
      const Vec2 centre = g.centre_of({column, row});
      EXPECT_LE(std::abs(std::atan2(centre.y, centre.x)), deg_to_rad(15));
      const double distance = norm(centre);
      if (value < 0.0F) {
        ++free;
        EXPECT_LT(distance, 1.05);
      } else {
        ++occupied;
        EXPECT_NEAR(distance, 1.0, 0.06);
      }
    }
  }
  EXPECT_NEAR(free, 0.5 * deg_to_rad(30) / (0.05 * 0.05), 15);
  EXPECT_GE(occupied, 8);
  EXPECT_LT(grid.log_odds(grid.cell_at({0.5, 0.01})), grid.log_odds(grid.cell_at({0.5, 0.11})));
  EXPECT_EQ(grid.log_odds(grid.cell_at({1.3, 0.0})), 0.0F);
}

TEST(ConeModel, SharesOneEchoAmongTheCellsItMayComeFrom) {
  const auto total = [](double width) {
    OccupancyGrid grid = grid_of_cells(0.02);
    EXPECT_TRUE(insert_cone(grid, sonar(width), {0, 0, 0}, 1.0));
    double sum = 0.0;
    double most = 0.0;
    for (const float value : grid.raster().cells) {
      if (value <= 0.0F) continue;
      sum += probability_of(value) - 0.5;
      most = std::max(most, probability_of(value) - 0.5);
    }
    EXPECT_LT(most, 0.35);
    return std::pair{sum, most};
  };
  const auto narrow = total(10);
  const auto wide = total(40);
  EXPECT_GT(narrow.second, wide.second) << "the wider the cone, the less is known of each cell";
  EXPECT_NEAR(wide.first, narrow.first, 0.1);
  // All shares together are those of one obstacle that was met.
  double weighted = 0.0;
  OccupancyGrid grid = grid_of_cells(0.02);
  ASSERT_TRUE(insert_cone(grid, sonar(40), {0, 0, 0}, 1.0));
  for (const float value : grid.raster().cells) {
    if (value > 0.0F) weighted += probability_of(value) - 0.5;
  }
  EXPECT_NEAR(weighted, 0.35, 1e-3);
}

TEST(ConeModel, OutOfRangeIsFreeToTheEndAsFarAsDropoutLetsIt) {
  ConeModel model = sonar();
  model.beam.dropout = 0.2;
  OccupancyGrid grid = grid_of_cells();
  ASSERT_TRUE(insert_cone(grid, model, {0, 0, 0}, kInfinite));
  double least = 0.0;
  for (const float value : grid.raster().cells) {
    EXPECT_LE(value, 0.0F);
    least = std::min<double>(least, value);
  }
  EXPECT_NEAR(least, log_odds_of(model.beam.probability_out_of_range()), 0.01);
  EXPECT_LT(grid.log_odds(grid.cell_at({1.9, 0.0})), 0.0F);
  EXPECT_EQ(grid.log_odds(grid.cell_at({2.1, 0.0})), 0.0F);
}

TEST(ConeModel, LooksWhereTheSensorDoes) {
  for (int i = 0; i < 8; ++i) {
    const double angle = i * kPi / 4 + 0.05;
    OccupancyGrid grid(GridGeometry::covering({-2, -2}, 4.0, 4.0, 0.05));
    ASSERT_TRUE(insert_cone(grid, sonar(), {0.1, -0.1, angle}, 1.2));
    const Vec2 ahead{std::cos(angle), std::sin(angle)};
    EXPECT_GT(grid.probability(Vec2{0.1, -0.1} + 1.2 * ahead), 0.5) << i;
    EXPECT_LT(grid.probability(Vec2{0.1, -0.1} + 0.7 * ahead), 0.4) << i;
    EXPECT_EQ(grid.probability(Vec2{0.1, -0.1} - 0.7 * ahead), 0.5) << i;
  }
}

TEST(ConeModel, SurvivesReadingsAndPosesThatAreNone) {
  OccupancyGrid grid = grid_of_cells();
  for (const double range : {kNotANumber, -kInfinite, -1.0}) {
    EXPECT_TRUE(insert_cone(grid, sonar(), {0, 0, 0}, range));
  }
  EXPECT_FALSE(insert_cone(grid, sonar(), {kNotANumber, 0, 0}, 1.0));
  EXPECT_FALSE(insert_cone(grid, sonar(), {0, kInfinite, 0}, 1.0));
  EXPECT_FALSE(insert_cone(grid, sonar(), {0, 0, kNotANumber}, 1.0));
  EXPECT_TRUE(insert_cone(grid, sonar(), {1e300, 0, 0}, 1.0)) << "too far away to see it";
  EXPECT_EQ(grid.revision(), 0u);
  EXPECT_TRUE(insert_cone(grid, sonar(), {0, 0, 0}, 0.0));
  EXPECT_THROW(static_cast<void>(insert_cone(grid, sonar(0), {0, 0, 0}, 1.0)),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(insert_cone(grid, sonar(200), {0, 0, 0}, 1.0)),
               std::invalid_argument);
}

TEST(ConeModel, OfASensorCountsWhatItsSurfacesMirrorAwayAsDropout) {
  robot::RangeSensorModel sensor;
  sensor.kind = robot::RangeKind::Ultrasound;
  sensor.ultrasound = {.beam_width = 0.4, .critical_angle = kPi / 2};
  sensor.error.dropout = 0.2;
  EXPECT_DOUBLE_EQ(cone_model_of(sensor).beam_width, 0.4);
  EXPECT_DOUBLE_EQ(cone_model_of(sensor).beam.dropout, 0.2) << "rough walls are always heard";
  sensor.ultrasound.critical_angle = kPi / 8;
  EXPECT_DOUBLE_EQ(cone_model_of(sensor).beam.dropout, 1 - 0.25 * 0.8);
}

TEST(BeamModel, OfAnInfraredSensorKnowsThatNearThingsReadAsFarOnes) {
  robot::RangeSensorModel sensor;
  sensor.kind = robot::RangeKind::Infrared;
  sensor.min_range = 0.1;
  sensor.max_range = 0.8;
  EXPECT_DOUBLE_EQ(beam_model_of(sensor).fold, 0.125);
  sensor.kind = robot::RangeKind::Ray;
  EXPECT_EQ(beam_model_of(sensor).fold, 0.0);
}

}  // namespace
}  // namespace eyebridge::mapping
