#include "eyebridge/mapping/ground_truth.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "bad_numbers.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::mapping {
namespace {

/// The grid with a letter a cell, upper row first: '#', '.' or '?'.
std::string drawn(const OccupancyGrid& grid) {
  std::string text;
  for (int row = grid.geometry().rows - 1; row >= 0; --row) {
    for (int column = 0; column < grid.geometry().columns; ++column) {
      const CellState state = grid.state(Cell{column, row});
      text += state == CellState::Occupied ? '#' : state == CellState::Free ? '.' : '?';
    }
    text += '\n';
  }
  return text;
}

world::Wall wall(Vec2 a, Vec2 b, double thickness = 0.0) {
  world::Wall made;
  made.a = a;
  made.b = b;
  made.thickness = thickness;
  return made;
}

world::WorldModel floor_of(double width, double height) {
  world::WorldModel model;
  model.width = width;
  model.height = height;
  return model;
}

TruthSettings coarse(int margin = 0) {
  TruthSettings settings;
  settings.resolution = 0.1;
  settings.margin = margin;
  return settings;
}

TEST(GroundTruth, PutsABareWallIntoTheCellsThatHoldIt) {
  world::WorldModel model = floor_of(0.6, 0.4);
  model.walls = {wall({0.15, 0.05}, {0.15, 0.25}), wall({0.3, 0.2}, {0.5, 0.2})};
  EXPECT_EQ(drawn(truth_of(model, coarse())),
            "......\n"
            ".#.###\n"  // the second one lies on the line between two rows: in the upper one
            ".#....\n"
            ".#....\n");
}

TEST(GroundTruth, HasRoomForTheWallsOnTheEdgeOfTheFloor) {
  world::WorldModel model = floor_of(0.3, 0.2);
  model.walls = {wall({0, 0}, {0.3, 0}), wall({0.3, 0}, {0.3, 0.2}), wall({0.3, 0.2}, {0, 0.2}),
                 wall({0, 0.2}, {0, 0})};
  EXPECT_EQ(drawn(truth_of(model, coarse(1))),
            ".####\n"
            ".#..#\n"
            ".####\n"
            ".....\n");
  const OccupancyGrid truth = truth_of(model, coarse(1));
  EXPECT_EQ(truth.state(Vec2{0.15, 0.15}), CellState::Free);
  EXPECT_EQ(truth.state(Vec2{0.31, 0.15}), CellState::Occupied);
}

TEST(GroundTruth, KnowsThickAndSlantedWalls) {
  world::WorldModel model = floor_of(0.8, 0.8);
  model.walls = {wall({0.05, 0.65}, {0.75, 0.65}, 0.2)};
  EXPECT_EQ(drawn(truth_of(model, coarse())).substr(0, 36),
            "########\n"
            "########\n"
            "########\n"
            "........\n")
      << "from 0.55 to 0.75 m, which are parts of three rows";
  model.walls = {wall({0.02, 0.03}, {0.78, 0.79})};
  const OccupancyGrid slanted = truth_of(model, coarse());
  for (int i = 0; i < 8; ++i) EXPECT_EQ(slanted.state(Cell{i, i}), CellState::Occupied) << i;
  EXPECT_EQ(slanted.state(Cell{0, 2}), CellState::Free);
  const std::string text = drawn(slanted);
  EXPECT_EQ(std::count(text.begin(), text.end(), '#'), 15) << "a staircase";
}

TEST(GroundTruth, KnowsWallsOfAnyLength) {
  world::WorldModel model = floor_of(0.4, 0.3);
  for (const double length : {5.0, 1e5, 1e11}) {
    model.walls = {wall({-length, 0.15}, {length, 0.15})};
    EXPECT_EQ(drawn(truth_of(model, coarse())),
              "....\n"
              "####\n"
              "....\n")
        << length;
  }
}

TEST(GroundTruth, HasBoxesAndCansWhenAskedForAndNoBalls) {
  world::WorldModel model = floor_of(1.0, 0.4);
  world::ObjectSpec box;
  box.kind = world::ObjectKind::Box;
  box.pose = {0.2, 0.2, kPi / 2};
  box.size = {0.18, 0.04};  // stands across
  world::ObjectSpec can;
  can.kind = world::ObjectKind::Can;
  can.pose = {0.65, 0.25, 0};
  can.radius = 0.06;
  world::ObjectSpec ball;
  ball.pose = {0.85, 0.15, 0};
  model.objects = {box, can, ball};
  TruthSettings settings = coarse();
  EXPECT_EQ(drawn(truth_of(model, settings)).find('#'), std::string::npos);
  settings.objects = true;
  EXPECT_EQ(drawn(truth_of(model, settings)),
            "......#...\n"
            ".##..###..\n"
            ".##...#...\n"
            "..........\n");
}

TEST(GroundTruth, HasPolygonsWhereTheyAreAndNotTheirCorners) {
  world::WorldModel model = floor_of(1.0, 0.5);
  world::ObjectSpec wedge;
  wedge.kind = world::ObjectKind::Polygon;
  wedge.pose = {0.44, 0.25, kPi};
  wedge.corners = {{0.3, 0.0}, {-0.15, 0.19}, {-0.15, -0.19}};  // its tip to the left
  model.objects = {wedge};
  TruthSettings settings = coarse();
  settings.objects = true;
  EXPECT_EQ(drawn(truth_of(model, settings)),
            "....##....\n"
            "..####....\n"
            ".#####....\n"
            "..####....\n"
            "....##....\n");
}

TEST(GroundTruth, RefusesWhatCannotBe) {
  const auto refusal = [](const world::WorldModel& model, const TruthSettings& settings) {
    try {
      truth_of(model, settings);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  TruthSettings settings;
  EXPECT_EQ(refusal(floor_of(1, 1), settings), "accepted");
  EXPECT_EQ(refusal(floor_of(0, 1), settings), "ground truth: the world has no floor");
  EXPECT_EQ(refusal(floor_of(1e6, 1e6), settings),
            "ground truth: the world has more cells than max_cells");
  settings.resolution = kNotANumber;
  EXPECT_EQ(refusal(floor_of(1, 1), settings),
            "ground truth: the resolution is not a positive number of metres");
  settings = {};
  settings.margin = -1;
  EXPECT_EQ(refusal(floor_of(1, 1), settings), "ground truth: the margin is not 0 to 1000000");
}

TEST(Agreement, CountsWhatIsObservedAndLetsAWallBeOneCellOff) {
  OccupancyGrid truth({{0, 0}, 0.1, 6, 1});
  OccupancyGrid belief({{-0.2, 0}, 0.1, 12, 1});  // reaches farther, to both sides
  const auto set = [](OccupancyGrid& grid, Vec2 place, double p) {
    grid.set_probability(grid.cell_at(place), p);
  };
  for (int i = 0; i < 6; ++i) set(truth, {0.1 * i + 0.05, 0.05}, i == 3 ? 0.9 : 0.1);
  set(belief, {0.05, 0.05}, 0.1);  // free, and is
  set(belief, {0.25, 0.05}, 0.9);  // occupied: the wall is one cell farther
  set(belief, {0.35, 0.05}, 0.1);  // free: the wall was found one cell before
  set(belief, {0.55, 0.05}, 0.9);  // occupied, and nothing is near
  set(belief, {0.75, 0.05}, 0.9);  // where the truth does not reach
  const Agreement one = agreement(belief, truth);
  EXPECT_EQ(one.observed, 4u);
  EXPECT_EQ(one.agreeing, 3u);
  EXPECT_EQ(one.share(), 0.75);
  EXPECT_EQ(agreement(belief, truth, 0).agreeing, 1u);
  EXPECT_EQ(agreement(belief, truth, 2).agreeing, 4u);
  EXPECT_EQ(agreement(OccupancyGrid({{0, 0}, 0.1, 6, 1}), truth).share(), 1.0);
}

TEST(Agreement, NeedsCellsThatLieOnEachOther) {
  const OccupancyGrid truth({{0, 0}, 0.1, 6, 1});
  EXPECT_THROW(agreement(OccupancyGrid({{0, 0}, 0.05, 6, 1}), truth), std::invalid_argument);
  EXPECT_THROW(agreement(OccupancyGrid({{0.05, 0}, 0.1, 6, 1}), truth), std::invalid_argument);
  EXPECT_THROW(agreement(OccupancyGrid({{1e30, 0}, 0.1, 6, 1}), truth), std::invalid_argument);
  EXPECT_THROW(agreement(truth, truth, -1), std::invalid_argument);
}

TEST(Coverage, IsOfTheCellsThatCanBeReached) {
  world::WorldModel model = floor_of(0.6, 0.3);
  model.walls = {wall({0.35, 0}, {0.35, 0.3})};
  const OccupancyGrid truth = truth_of(model, coarse());
  OccupancyGrid belief({{0, 0}, 0.1, 6, 3});
  EXPECT_EQ(coverage(belief, truth, {0.05, 0.05}), 0.0);
  for (int row = 0; row < 3; ++row) belief.set_probability({1, row}, 0.1);
  belief.set_probability({5, 0}, 0.1);  // on the other side
  EXPECT_NEAR(coverage(belief, truth, {0.05, 0.05}), 3.0 / 9.0, 1e-12);
  EXPECT_NEAR(coverage(belief, truth, {0.55, 0.05}), 1.0 / 6.0, 1e-12);
  EXPECT_EQ(coverage(belief, truth, {0.35, 0.05}), 0.0) << "starts in a wall";
  EXPECT_EQ(coverage(belief, truth, {kNotANumber, 0.05}), 0.0);
}

}  // namespace
}  // namespace eyebridge::mapping
