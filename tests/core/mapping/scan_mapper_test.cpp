#include "eyebridge/mapping/scan_mapper.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "bad_numbers.hpp"
#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::mapping {
namespace {

constexpr double kResolution = 0.05;

BeamModel model_with(double sigma, double max_range = 3.0) {
  BeamModel model;
  model.max_range = max_range;
  model.sigma = sigma;
  return model;
}

OccupancyGrid grid_of(int columns, int rows, Vec2 origin = {0, 0}) {
  return OccupancyGrid({origin, kResolution, columns, rows});
}

std::vector<Vec2> fan(std::size_t count, double gap, double first = 0.1) {
  std::vector<Vec2> directions;
  for (std::size_t i = 0; i < count; ++i) {
    directions.push_back(Heading::from_angle(first + gap * static_cast<double>(i)).forward());
  }
  return directions;
}

double evidence(double probability) { return log_odds_of(probability); }

TEST(ScanMapper, GivesTheCellsOfABeamTheirInverseModelsEvidence) {
  for (const double sigma : {0.0, 0.02, 0.08}) {
    OccupancyGrid grid = grid_of(60, 3);
    const BeamModel model = model_with(sigma);
    ScanMapper mapper(model);
    const Vec2 ahead{1, 0};
    const double range = 1.4;
    ASSERT_TRUE(mapper.insert(grid, {0.125, 0.075}, {&ahead, 1}, {&range, 1}));
    for (int column = 0; column < 60; ++column) {
      const double near = column * kResolution - 0.125;
      const double p = model.probability(range, near, near + kResolution);
      const double expected = column < 2 ? 0.0 : evidence(p);
      EXPECT_NEAR(grid.log_odds({column, 1}), expected, 0.06) << column << " sigma " << sigma;
      EXPECT_EQ(grid.log_odds({column, 0}), 0.0F);
      EXPECT_EQ(grid.log_odds({column, 2}), 0.0F);
    }
  }
}

TEST(ScanMapper, FollowsSlantedBeamsThroughTheCellsTheyCross) {
  for (int i = 0; i < 64; ++i) {
    OccupancyGrid grid = grid_of(80, 80);
    ScanMapper mapper(model_with(0.0));
    const Vec2 direction = Heading::from_angle(2 * kPi * (i + 0.3) / 64).forward();
    const Vec2 origin{2.013, 1.987};
    const double range = 1.7;
    ASSERT_TRUE(mapper.insert(grid, origin, {&direction, 1}, {&range, 1}));
    EXPECT_GT(grid.log_odds(grid.cell_at(origin + range * direction)), 0.0F) << i;
    int free = 0;
    int changed = 0;
    for (int row = 0; row < 80; ++row) {
      for (int column = 0; column < 80; ++column) {
        const Cell cell{column, row};
        if (grid.log_odds(cell) == 0.0F) continue;
        ++changed;
        if (grid.log_odds(cell) < 0.0F) ++free;
        const Vec2 away = grid.geometry().centre_of(cell) - origin;
        EXPECT_LE(std::abs(cross(direction, away)), 0.71 * kResolution) << "not on the beam";
        EXPECT_GE(dot(direction, away), -0.71 * kResolution);
        EXPECT_LE(dot(direction, away), range + 1.5 * kResolution);
      }
    }
    const double columns =
        range / kResolution * std::max(std::abs(direction.x), std::abs(direction.y));
    EXPECT_NEAR(free, columns, 1.6) << i;
    EXPECT_LE(changed - free, 2) << i;
  }
}

TEST(ScanMapper, FindsTheCellThatAFarBeamEndsIn) {
  // 10 m are 10 000 cells.
  OccupancyGrid grid({{0, 0}, 0.001, 100, 100});
  for (int i = 0; i < 50; ++i) {
    grid.clear();
    BeamModel model = model_with(0.0, 12.0);
    ScanMapper mapper(model);
    const Vec2 direction = Heading::from_angle(0.3 + 0.013 * i).forward();
    const Vec2 end{0.0412, 0.0573};
    const double range = 10.0;
    ASSERT_TRUE(mapper.insert(grid, end - range * direction, {&direction, 1}, {&range, 1}));
    EXPECT_GT(grid.log_odds(grid.cell_at(end)), 1.0F) << i;
  }
}

TEST(ScanMapper, CountsEachCellOnceAScan) {
  OccupancyGrid grid = grid_of(80, 80);
  const BeamModel model = model_with(0.0);
  ScanMapper mapper(model);
  const std::vector<Vec2> directions = fan(720, 2 * kPi / 720);
  const std::vector<double> ranges(720, 1.5);
  ASSERT_TRUE(mapper.insert(grid, {2.0, 2.0}, directions, ranges));
  const auto crossed = static_cast<float>(evidence(model.crossed));
  const auto met = static_cast<float>(evidence(model.met));
  int free = 0;
  for (const float value : grid.raster().cells) {
    EXPECT_GE(value, crossed);
    EXPECT_LE(value, met + 1e-3F);
    if (value == crossed) ++free;
  }
  EXPECT_NEAR(free, kPi * 1.5 * 1.5 / (kResolution * kResolution), 150);
}

TEST(ScanMapper, LetsAnObstacleThatWasMetCountBeforeACrossing) {
  OccupancyGrid grid = grid_of(40, 3);
  ScanMapper mapper(model_with(0.0));
  const std::vector<Vec2> both{{1, 0}, {1, 0}, {1, 0}};
  const std::vector<double> ranges{1.5, 0.5, 3.0};
  ASSERT_TRUE(mapper.insert(grid, {0.025, 0.075}, both, ranges));
  EXPECT_GT(grid.log_odds(grid.cell_at({0.525, 0.075})), 1.0F);
  EXPECT_GT(grid.log_odds(grid.cell_at({1.5, 0.075})), 1.0F);
  EXPECT_LT(grid.log_odds(grid.cell_at({1.0, 0.075})), 0.0F);
}

TEST(ScanMapper, SaysLittleWhereADropoutMayHideAnObstacle) {
  BeamModel model = model_with(0.0);
  model.dropout = 0.4;
  ScanMapper mapper(model);
  OccupancyGrid grid = grid_of(100, 3);
  const Vec2 ahead{1, 0};
  for (const double range : {3.0, kInfinite}) {
    grid.clear();
    ASSERT_TRUE(mapper.insert(grid, {0.025, 0.075}, {&ahead, 1}, {&range, 1}));
    const auto expected = static_cast<float>(evidence(model.probability_out_of_range()));
    EXPECT_EQ(grid.log_odds({20, 1}), expected);
    EXPECT_EQ(grid.log_odds({59, 1}), expected);
    EXPECT_EQ(grid.log_odds({61, 1}), 0.0F);
  }
}

TEST(ScanMapper, KnowsNothingNearerThanTheLeastRangeOfABeamOutOfRange) {
  BeamModel model = model_with(0.0);
  model.min_range = 0.5;
  ScanMapper mapper(model);
  OccupancyGrid grid = grid_of(100, 3);
  const Vec2 ahead{1, 0};
  double range = 3.0;
  ASSERT_TRUE(mapper.insert(grid, {0.025, 0.075}, {&ahead, 1}, {&range, 1}));
  EXPECT_EQ(grid.log_odds({9, 1}), 0.0F);
  EXPECT_LT(grid.log_odds({11, 1}), 0.0F);
  grid.clear();
  range = 1.0;
  ASSERT_TRUE(mapper.insert(grid, {0.025, 0.075}, {&ahead, 1}, {&range, 1}));
  EXPECT_LT(grid.log_odds({0, 1}), 0.0F) << "what it met is farther off";
  model.fold = 0.3;
  ScanMapper folding(model);
  grid.clear();
  ASSERT_TRUE(folding.insert(grid, {0.025, 0.075}, {&ahead, 1}, {&range, 1}));
  EXPECT_NEAR(grid.log_odds({5, 1}), evidence(model.probability(range, 0.225, 0.275)), 1e-6);
  EXPECT_NEAR(grid.log_odds({15, 1}), evidence(model.probability(range, 0.725, 0.775)), 1e-6);
}

TEST(ScanMapper, HidesSurfacesNearerThanTheLeastRangeAlongSlantedBeams) {
  BeamModel model = model_with(0.0);
  model.min_range = 0.5;
  model.fold = 0.3;
  ScanMapper mapper(model);
  OccupancyGrid grid = grid_of(60, 60);
  const Vec2 slanted{std::sqrt(0.5), std::sqrt(0.5)};
  const double range = 1.5;
  ASSERT_TRUE(mapper.insert(grid, {0.025, 0.025}, {&slanted, 1}, {&range, 1}));
  for (int i = 1; i < 19; ++i) {
    const double away = i * kResolution / slanted.x;
    const double near = away - 0.5 * kResolution;
    EXPECT_NEAR(grid.log_odds({i, i}), evidence(model.probability(range, near, near + kResolution)),
                1e-6)
        << away << " m away";
  }
}

TEST(ScanMapper, GivesTheSameWhereverTheGridEnds) {
  // Cells of a small grid, beams of which most lie outside, against the same cells of a large one.
  const std::vector<Vec2> directions = fan(181, 2 * kPi / 181);
  Random random(5);
  for (int round = 0; round < 50; ++round) {
    std::vector<double> ranges;
    for (std::size_t i = 0; i < directions.size(); ++i) ranges.push_back(3.3 * random.uniform());
    const Vec2 origin{8.0 * random.uniform() - 3.0, 8.0 * random.uniform() - 3.0};
    ScanMapper mapper(model_with(0.03));
    OccupancyGrid small = grid_of(37, 23);
    OccupancyGrid large = grid_of(37 + 400, 23 + 400, {-200 * kResolution, -200 * kResolution});
    ASSERT_TRUE(mapper.insert(small, origin, directions, ranges));
    ASSERT_TRUE(mapper.insert(large, origin, directions, ranges));
    int differ = 0;
    for (int row = 0; row < 23; ++row) {
      for (int column = 0; column < 37; ++column) {
        const float a = small.log_odds({column, row});
        const float b = large.log_odds({column + 200, row + 200});
        if (std::abs(a - b) > 1e-6F) ++differ;
      }
    }
    EXPECT_LE(differ, 1) << round;  // a beam through a corner may be rounded to either side
  }
}

TEST(ScanMapper, MapsASweepAsItDoesItsBeamsOneByOne) {
  Random random(11);
  std::size_t changed = 0;
  std::size_t different = 0;
  for (int round = 0; round < 60; ++round) {
    const std::size_t count = 90 + 90 * static_cast<std::size_t>(round % 8);
    const double gap = (round % 2 == 0 ? 1.0 : -1.0) * (round % 3 == 0 ? kPi : 2 * kPi) /
                       static_cast<double>(count);
    const std::vector<Vec2> directions = fan(count, gap, 7 * random.uniform());
    std::vector<double> ranges(count);
    double range = 1.0;
    for (std::size_t i = 0; i < count; ++i) {
      if (random.chance(0.1)) range = 0.2 + 3.0 * random.uniform();  // a corner
      ranges[i] = random.chance(0.02) ? kNotANumber : range + 0.01 * random.gaussian();
    }
    const Vec2 origin{4.0 + random.uniform(), 4.0 + random.uniform()};
    ScanMapper mapper(model_with(0.02));
    OccupancyGrid one_by_one = grid_of(180, 180);
    OccupancyGrid sweep = grid_of(180, 180);
    ASSERT_TRUE(mapper.insert(one_by_one, origin, directions, ranges));
    ASSERT_TRUE(mapper.insert_sweep(sweep, origin, directions, gap, ranges));
    for (std::size_t i = 0; i < sweep.raster().cells.size(); ++i) {
      if (one_by_one.raster().cells[i] != 0.0F) ++changed;
      if (one_by_one.raster().cells[i] != sweep.raster().cells[i]) ++different;
    }
  }
  EXPECT_GT(changed, 100'000u);
  // Where a short beam lies beside long ones, a cell that only its own column touches is missed.
  EXPECT_LT(static_cast<double>(different), 0.001 * static_cast<double>(changed)) << different;
}

TEST(ScanMapper, GrowsAGridThatMayGrow) {
  OccupancySettings settings;
  settings.growing = true;
  OccupancyGrid grid({{0, 0}, kResolution, 4, 4}, settings);
  ScanMapper mapper(model_with(0.0));
  const std::vector<Vec2> directions = fan(4, kPi / 2, 0.0);
  const std::vector<double> ranges(4, 1.5);
  ASSERT_TRUE(mapper.insert(grid, {0.1225, 0.1225}, directions, ranges));
  for (const Vec2 direction : directions) {
    EXPECT_EQ(grid.state(Vec2{0.1225, 0.1225} + 1.5 * direction), CellState::Occupied);
  }
  settings.max_cells = 400;
  OccupancyGrid narrow({{0, 0}, kResolution, 4, 4}, settings);
  const auto result = mapper.insert(narrow, {0.1225, 0.1225}, directions, ranges);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, Errc::OutOfRange);
  EXPECT_EQ(narrow.raster(), OccupancyGrid({{0, 0}, kResolution, 4, 4}).raster());
}

TEST(ScanMapper, PassesOverReadingsThatSayNothingAndRefusesPlacesThatAreNone) {
  OccupancyGrid grid = grid_of(40, 40);
  ScanMapper mapper(model_with(0.02));
  const std::vector<Vec2> directions = fan(4, kPi / 2);
  const std::vector<double> nothing{kNotANumber, -kInfinite, -1.0, -0.001};
  ASSERT_TRUE(mapper.insert(grid, {1, 1}, directions, nothing));
  EXPECT_EQ(grid.revision(), 0u);
  const std::vector<double> ranges{1.0, 1e308, kInfinite, 0.0};
  EXPECT_TRUE(mapper.insert(grid, {1, 1}, directions, ranges));
  for (const float value : grid.raster().cells) ASSERT_TRUE(std::isfinite(value));
  const auto before = grid.raster();
  EXPECT_FALSE(mapper.insert(grid, {kNotANumber, 1}, directions, ranges));
  EXPECT_FALSE(mapper.insert(grid, {1, kInfinite}, directions, ranges));
  std::vector<Vec2> bad = directions;
  bad[2].x = kNotANumber;
  EXPECT_FALSE(mapper.insert(grid, {1, 1}, bad, ranges));
  EXPECT_TRUE(mapper.insert(grid, {1e300, 1}, directions, ranges)) << "too far away to see it";
  EXPECT_EQ(grid.raster(), before);
  EXPECT_THROW(static_cast<void>(mapper.insert(grid, {1, 1}, directions, {})),
               std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::mapping
