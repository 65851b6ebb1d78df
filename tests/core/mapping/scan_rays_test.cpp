#include "scan_rays.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "bad_numbers.hpp"
#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/mapping/scan_mapper.hpp"
#include "instruction_sets.hpp"

namespace eyebridge::mapping {
namespace {

constexpr double kCellSide = 0.05;
constexpr int kSide = 150;  // cells
constexpr Vec2 kMiddle{75.3, 74.8};

BeamModel some_model(int round) {
  BeamModel model;
  model.max_range = 3.0;
  model.sigma = 0.01 + 0.01 * (round % 5);
  model.sigma_relative = round % 2 == 0 ? 0.0 : 0.02;
  model.sigma_quadratic = round % 3 == 0 ? 0.01 : 0.0;  // not simple
  model.bias = round % 4 == 0 ? 0.02 : 0.0;
  return model;
}

struct RayScan {
  std::vector<Vec2> directions;
  std::vector<double> ranges;
};

RayScan random_scan(Random& random, std::size_t count) {
  RayScan scan;
  const double first = 7 * random.uniform();
  double range = 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = first + 2 * kPi * static_cast<double>(i) / static_cast<double>(count);
    scan.directions.push_back(Heading::from_angle(angle).forward());
    if (random.chance(0.1)) range = 3.3 * random.uniform();
    const double noisy = std::max(range + 0.01 * random.gaussian(), 0.0);
    scan.ranges.push_back(random.chance(0.03) ? kNotANumber : noisy);
  }
  return scan;
}

/// A grid after one scan.
OccupancyGrid grid_after(const BeamModel& model, const RayScan& scan, bool clipped) {
  OccupancyGrid grid({{0, 0}, kCellSide, kSide, kSide});
  const BeamTable table(model, kCellSide);
  ScanRays rays;
  const double close = 0.7 * static_cast<double>(scan.ranges.size()) / (2 * kPi);
  const RayModel all{model.max_range, model.out_of_range, model.bias, 1.0 / kCellSide, close, true};
  EXPECT_TRUE(rays.set(table, all, scan.directions, scan.ranges));
  RayFrame frame;
  frame.box = {kSide, kSide, ScanNotes::stride_of(kSide)};
  frame.origin = clipped ? Vec2{20.3, 30.8} : kMiddle;
  frame.column = clipped ? 20 : 75;
  frame.row = clipped ? 30 : 74;
  frame.clipped = clipped;
  ScanNotes notes;
  notes.begin(frame.box);
  PolygonFill fill;
  fill.begin(frame.box);
  fill.flip(frame.origin, rays.corner_x, rays.corner_y, false);
  const float own = rays.draw(table, frame, notes.writer());
  notes.writer().say(frame.box.index_of(frame.column, frame.row), own);
  notes.apply(grid, {0, 0}, fill, table.crossed);
  return grid;
}

TEST(Box, HasOneIndexBehindItForAllCellsOutside) {
  const Box box{3, 2, 8};
  EXPECT_EQ(box.size(), 16U);
  EXPECT_EQ(box.index_of(0, 0), 0U);
  EXPECT_EQ(box.index_of(2, 0), 2U);
  EXPECT_EQ(box.index_of(0, 1), 8U);
  EXPECT_EQ(box.index_of(2, 1), 10U);
  for (const int column : {-1, 3, 100}) EXPECT_EQ(box.index_of(column, 0), box.size()) << column;
  for (const int row : {-1, 2, 100}) EXPECT_EQ(box.index_of(1, row), box.size()) << row;
}

TEST(ScanRays, DrawsWhatBeamsSayOneByOneInAllInstructions) {
  Random random(9);
  std::size_t changed = 0;
  std::size_t different = 0;
  for (int round = 0; round < 40; ++round) {
    const BeamModel model = some_model(round);
    RayScan scan = random_scan(random, 90 + static_cast<std::size_t>(310 * random.uniform()));
    for (double& range : scan.ranges) {
      if (range >= 2.9) range = kNotANumber;  // what is out of range others draw
    }
    OccupancyGrid one_by_one({{0, 0}, kCellSide, kSide, kSide});
    ASSERT_TRUE(
        ScanMapper(model).insert(one_by_one, kCellSide * kMiddle, scan.directions, scan.ranges));
    const OccupancyGrid plain = grid_after(model, scan, false);
    in_every_instruction_set([&](const std::string& name) {
      EXPECT_EQ(plain.raster(), grid_after(model, scan, false).raster()) << name << round;
    });
    for (std::size_t i = 0; i < plain.raster().cells.size(); ++i) {
      if (one_by_one.raster().cells[i] != 0.0F) ++changed;
      if (std::abs(one_by_one.raster().cells[i] - plain.raster().cells[i]) > 1e-3F) ++different;
    }
  }
  EXPECT_GT(changed, 40'000u);
  EXPECT_LT(static_cast<double>(different), 0.001 * static_cast<double>(changed)) << different;
}

TEST(ScanRays, DrawsTheSameInAllInstructionsWhereABoxEnds) {
  Random random(10);
  for (int round = 0; round < 40; ++round) {
    const RayScan scan = random_scan(random, 1 + static_cast<std::size_t>(400 * random.uniform()));
    const OccupancyGrid plain = grid_after(some_model(round), scan, true);
    in_every_instruction_set([&](const std::string& name) {
      EXPECT_EQ(plain.raster(), grid_after(some_model(round), scan, true).raster())
          << name << round;
    });
  }
}

TEST(ScanRays, RefusesDirectionsThatAreNoUnitVectors) {
  const BeamModel model = some_model(1);
  const BeamTable table(model, kCellSide);
  const RayModel all{model.max_range, model.out_of_range, 0.0, 1.0 / kCellSide, 30.0, true};
  ScanRays rays;
  for (const Vec2 bad :
       {Vec2{0, 0}, Vec2{0.5, 0}, Vec2{1, 1}, Vec2{kNotANumber, 0}, Vec2{0, kInfinite}}) {
    std::vector<Vec2> directions(9, Vec2{0.6, 0.8});
    const std::vector<double> ranges(9, 1.0);
    EXPECT_TRUE(rays.set(table, all, directions, ranges));
    directions[4] = bad;
    in_every_instruction_set([&](const std::string& name) {
      EXPECT_FALSE(rays.set(table, all, directions, ranges))
          << bad.x << ' ' << bad.y << ' ' << name;
    });
  }
}

}  // namespace
}  // namespace eyebridge::mapping
