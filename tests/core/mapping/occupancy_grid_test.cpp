#include "eyebridge/mapping/occupancy_grid.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "bad_numbers.hpp"
#include "eyebridge/mapping/picture.hpp"
#include "process_memory.hpp"

namespace eyebridge::mapping {
namespace {

GridGeometry four_by_three() { return {{0, 0}, 0.5, 4, 3}; }

std::string refusal(const GridGeometry& geometry, const OccupancySettings& settings = {}) {
  try {
    OccupancyGrid(geometry, settings);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(OccupancyGrid, FollowsBayesRuleAsATableDoesByHand) {
  // P(occ | readings) by hand, in fractions: odds are multiplied by p / (1 - p) of each reading,
  // and divided by the prior's.
  OccupancyGrid grid(four_by_three());
  const Vec2 point{0.7, 0.2};
  struct Row {
    double reading;
    double expected;
  };
  const Row rows[] = {{0.8, 4.0 / 5.0},   // odds 1 * 4
                      {0.6, 6.0 / 7.0},   // 4 * 3/2 = 6
                      {0.25, 2.0 / 3.0},  // 6 * 1/3 = 2
                      {0.1, 2.0 / 11.0},  // 2 * 1/9 = 2/9
                      {0.5, 2.0 / 11.0},  // says nothing
                      {0.9, 2.0 / 3.0}};  // 2/9 * 9 = 2
  for (const Row& row : rows) {
    ASSERT_TRUE(grid.update(point, row.reading));
    EXPECT_NEAR(grid.probability(point), row.expected, 1e-7) << row.reading;
  }
  EXPECT_EQ(grid.probability(Vec2{0.2, 0.2}), 0.5) << "a neighbour learnt nothing";
}

TEST(OccupancyGrid, DividesByThePriorOnceAReading) {
  OccupancySettings settings;
  settings.prior = 0.2;  // odds 1/4
  OccupancyGrid grid(four_by_three(), settings);
  EXPECT_NEAR(grid.probability(Cell{1, 1}), 0.2, 1e-7);
  // Posterior odds = odds(p) * odds / prior odds: the first reading is the posterior itself.
  ASSERT_TRUE(grid.update({0.7, 0.7}, 0.6));
  EXPECT_NEAR(grid.probability(Cell{1, 1}), 0.6, 1e-7);
  ASSERT_TRUE(grid.update({0.7, 0.7}, 0.6));  // 3/2 * 3/2 * 4 = 9
  EXPECT_NEAR(grid.probability(Cell{1, 1}), 0.9, 1e-7);
}

TEST(OccupancyGrid, KeepsLogOddsWithinTheirLimitsSoThatABeliefCanChange) {
  OccupancyGrid grid(four_by_three());
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(grid.update({0.1, 0.1}, 0.99));
  EXPECT_EQ(grid.log_odds({0, 0}), 5.0F);
  ASSERT_TRUE(grid.update({0.1, 0.1}, 0.0));
  EXPECT_EQ(grid.log_odds({0, 0}), -5.0F);
  ASSERT_TRUE(grid.update({0.1, 0.1}, 1.0));
  EXPECT_EQ(grid.log_odds({0, 0}), 5.0F);
}

TEST(OccupancyGrid, TellsStatesByTheThresholdsOfRos) {
  OccupancyGrid grid(four_by_three());
  const auto state = [&](double p) {
    grid.set_probability({0, 0}, p);
    return grid.state(Cell{0, 0});
  };
  EXPECT_EQ(state(0.66), CellState::Occupied);
  EXPECT_EQ(state(0.64), CellState::Unknown);
  EXPECT_EQ(state(0.20), CellState::Unknown);
  EXPECT_EQ(state(0.19), CellState::Free);
  EXPECT_EQ(grid.state(Cell{9, 9}), CellState::Unknown);
  EXPECT_EQ(grid.state(Vec2{kNotANumber, 0}), CellState::Unknown);
}

TEST(OccupancyGrid, ForgetsByHalvesOfLogOdds) {
  OccupancySettings settings;
  settings.half_life = 10.0;
  settings.prior = 0.3;
  OccupancyGrid grid(four_by_three(), settings);
  const float prior = grid.prior();
  grid.set_probability({2, 1}, 0.9);
  const float known = grid.log_odds({2, 1}) - prior;
  grid.decay(10.0);
  EXPECT_NEAR(grid.log_odds({2, 1}) - prior, known / 2, 1e-6);
  grid.decay(5.0);
  grid.decay(5.0);
  EXPECT_NEAR(grid.log_odds({2, 1}) - prior, known / 4, 1e-6);
  EXPECT_EQ(grid.log_odds({0, 0}), prior);
  grid.decay(1e9);
  EXPECT_EQ(grid.log_odds({2, 1}), prior);
}

TEST(OccupancyGrid, NeverForgetsWithoutAHalfLife) {
  OccupancyGrid grid(four_by_three());
  grid.set_probability({2, 1}, 0.9);
  const auto before = grid.raster();
  const auto revision = grid.revision();
  grid.decay(1e9);
  EXPECT_EQ(grid.raster(), before);
  EXPECT_EQ(grid.revision(), revision);
}

TEST(OccupancyGrid, GrowsOverEvidenceAndKeepsWhatItKnewInPlace) {
  OccupancySettings settings;
  settings.growing = true;
  OccupancyGrid grid({{0.3, -0.7}, 0.1, 5, 5}, settings);
  ASSERT_TRUE(grid.update({0.55, -0.45}, 0.9));
  for (const Vec2 point : {Vec2{-3.12, 0.5}, Vec2{4.0, 5.55}, Vec2{0.0, -9.0}}) {
    ASSERT_TRUE(grid.update(point, 0.8));
    EXPECT_NEAR(grid.probability(point), 0.8, 1e-6);
    EXPECT_NEAR(grid.probability(Vec2{0.55, -0.45}), 0.9, 1e-6);
  }
  const Vec2 steps = (grid.geometry().origin - Vec2{0.3, -0.7}) * (1.0 / 0.1);
  EXPECT_NEAR(steps.x, std::nearbyint(steps.x), 1e-9) << "cells stay where they were";
  EXPECT_NEAR(steps.y, std::nearbyint(steps.y), 1e-9);
}

TEST(OccupancyGrid, RefusesToGrowBeyondItsLimitAndSaysSo) {
  OccupancySettings settings;
  settings.growing = true;
  settings.max_cells = 1000;
  OccupancyGrid grid({{0, 0}, 1.0, 10, 10}, settings);
  ASSERT_TRUE(grid.update({99.5, 9.5}, 0.8)) << "100 x 10 fits, without room to spare";
  EXPECT_EQ(grid.geometry().columns, 100);
  const auto before = grid.raster();
  const auto far = grid.update({100.5, 9.5}, 0.8);
  ASSERT_FALSE(far);
  EXPECT_EQ(far.error().code, Errc::OutOfRange);
  EXPECT_EQ(far.error().what, "the grid would grow to 101 x 10 cells: expected at most 1000");
  EXPECT_FALSE(grid.update({1e300, 0}, 0.8));
  EXPECT_EQ(grid.raster(), before);
}

TEST(OccupancyGrid, KeepsItsBoundsAndMemoryUnlessItGrows) {
  OccupancyGrid grid(four_by_three());
  const float* const cells = grid.raster().cells.data();
  EXPECT_TRUE(grid.update({17.0, 0.0}, 0.9));
  EXPECT_TRUE(grid.cover({-10, -10}, {10, 10}));
  EXPECT_EQ(grid.geometry(), four_by_three());
  EXPECT_EQ(grid.raster().cells.data(), cells);
  EXPECT_EQ(grid.raster(), OccupancyGrid(four_by_three()).raster());
}

// Much less than the 100 MB of a map of 100 x 100 m with cells of 2 cm. The kernel may give 2 MB at
// once, and the address sanitizer keeps notes of an eighth.
constexpr std::size_t kSome = 40U << 20U;

TEST(OccupancyGrid, TakesMemoryForWhatIsSeen) {
  const std::size_t before = testing::resident_bytes();
  OccupancyGrid grid({{0, 0}, 0.02, 5000, 5000});
  for (int row = 1000; row < 1100; ++row) {
    for (int column = 1000; column < 1100; ++column) grid.add({column, row}, 1.0F);
  }
  const OccupancyGrid copy = grid;
  EXPECT_EQ(copy.raster(), grid.raster());
  grid.clear();
  EXPECT_EQ(grid.probability(Cell{1050, 1050}), 0.5);
  EXPECT_EQ(copy.state(Cell{1050, 1050}), CellState::Occupied);
  EXPECT_LT(testing::resident_bytes(), before + kSome);
}

TEST(OccupancyGrid, TakesMemoryForWhatIsSeenWhenItGrowsAndForgets) {
  const std::size_t before = testing::resident_bytes();
  OccupancySettings settings;
  settings.growing = true;
  settings.half_life = 10.0;
  OccupancyGrid grid({{0, 0}, 0.02, 100, 100}, settings);
  ASSERT_TRUE(grid.update({1, 1}, 0.9));
  ASSERT_TRUE(grid.cover({-50, -50}, {50, 50}));
  ASSERT_GT(grid.geometry().size(), std::size_t{25'000'000});
  grid.decay(10.0);
  EXPECT_NEAR(grid.probability(Vec2{1, 1}), 0.75, 1e-6) << "odds of 9 become 3";
  EXPECT_LT(testing::resident_bytes(), before + kSome);
}

TEST(OccupancyGrid, OfAnotherPriorIsClearedAndFadesAsAWhole) {
  OccupancySettings settings;
  settings.prior = 0.2;
  settings.half_life = 10.0;
  settings.growing = true;
  OccupancyGrid grid({{0, 0}, 1.0, 64, 64}, settings);
  for (int row = 0; row < 64; ++row) {
    for (int column = 0; column < 64; ++column) grid.set_probability({column, row}, 0.5);
  }
  ASSERT_TRUE(grid.cover({-100, -100}, {100, 100}));
  EXPECT_NEAR(grid.probability(Vec2{-50, -50}), 0.2, 1e-6);
  EXPECT_NEAR(grid.probability(Vec2{8, 8}), 0.5, 1e-6) << "log-odds of 0 are known, too";
  grid.decay(10.0);
  EXPECT_NEAR(grid.probability(Vec2{8, 8}), 1.0 / 3.0, 1e-6) << "odds of 1/4 and 1: 1/2";
  grid.clear();
  EXPECT_NEAR(grid.probability(Vec2{8, 8}), 0.2, 1e-6);
}

TEST(OccupancyGrid, RefusesEvidenceThatIsNone) {
  OccupancyGrid grid(four_by_three());
  for (const double bad : {kNotANumber, -0.1, 1.1, kInfinite})
    EXPECT_FALSE(grid.update({0.1, 0.1}, bad));
  for (const double bad : {kNotANumber, kInfinite, -kInfinite}) {
    EXPECT_FALSE(grid.update({bad, 0.1}, 0.9));
    EXPECT_FALSE(grid.update({0.1, bad}, 0.9));
    EXPECT_EQ(grid.probability(Vec2{bad, 0.1}), 0.5);
  }
  EXPECT_EQ(grid.probability(Vec2{1e30, 0.1}), 0.5);
  EXPECT_EQ(grid.revision(), 0u);
}

TEST(OccupancyGrid, CountsEveryChange) {
  OccupancyGrid grid(four_by_three());
  std::uint64_t last = grid.revision();
  const auto changed = [&] { return std::exchange(last, grid.revision()) != grid.revision(); };
  ASSERT_TRUE(grid.update({0.1, 0.1}, 0.9));
  EXPECT_TRUE(changed());
  EXPECT_FALSE(changed());
  grid.set_probability({1, 1}, 0.9);
  EXPECT_TRUE(changed());
  grid.clear();
  EXPECT_TRUE(changed());
  EXPECT_EQ(grid.raster(), OccupancyGrid(four_by_three()).raster());
}

TEST(OccupancyGrid, RefusesSettingsThatCannotBe) {
  const GridGeometry good = four_by_three();
  EXPECT_EQ(refusal(good), "accepted");
  EXPECT_EQ(refusal({{0, 0}, -0.05, 4, 3}),
            "occupancy grid: the resolution is not a positive number of metres");
  EXPECT_EQ(refusal({{0, 0}, kNotANumber, 4, 3}),
            "occupancy grid: the resolution is not a positive number of metres");
  EXPECT_EQ(refusal({{kNotANumber, 0}, 0.05, 4, 3}), "occupancy grid: the origin is not finite");
  EXPECT_EQ(refusal({{0, 0}, 0.05, 0, 3}), "occupancy grid: it has no cells");
  EXPECT_EQ(refusal({{0, 0}, 0.05, 1 << 20, 1 << 20}),
            "occupancy grid: it has 1048576 x 1048576 cells: expected at most 67108864");
  OccupancySettings settings;
  settings.prior = 1.0;
  EXPECT_EQ(refusal(good, settings), "occupancy grid: the prior is not between 0 and 1");
  settings = {};
  settings.lowest = 1.0;
  EXPECT_EQ(refusal(good, settings),
            "occupancy grid: the limits of log-odds do not enclose those of the prior");
  settings = {};
  settings.free_below = 0.7;
  EXPECT_EQ(refusal(good, settings),
            "occupancy grid: the thresholds are not 0 < free_below <= occupied_above < 1");
  settings = {};
  settings.half_life = -1.0;
  EXPECT_EQ(refusal(good, settings), "occupancy grid: the half-life is negative");
}

TEST(Picture, HasTheGreysOfRos) {
  OccupancyGrid grid({{0, 0}, 1.0, 3, 1});
  grid.set_probability({0, 0}, 0.8);
  grid.set_probability({1, 0}, 0.19);
  EXPECT_EQ(picture_of(grid).cells, (std::vector<std::uint8_t>{0, 254, 205}));
  EXPECT_EQ(picture_of(grid, PictureKind::Probabilities).cells,
            (std::vector<std::uint8_t>{51, 207, 128}));
}

}  // namespace
}  // namespace eyebridge::mapping
