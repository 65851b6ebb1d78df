#include "eyebridge/planning/frontiers.hpp"

#include <cmath>
#include <cstdlib>
#include <string_view>

#include <gtest/gtest.h>

#include "eyebridge/planning/sight.hpp"
#include "eyebridge/planning/wavefront.hpp"
#include "grids.hpp"

namespace eyebridge::planning {
namespace {

using mapping::Cell;
using mapping::CellState;

/// '?' unknown, '.' free, '#' occupied; the upper row first.
KnowledgeRaster known_as(const std::vector<std::string_view>& rows, double resolution = 1.0) {
  const int columns = static_cast<int>(rows.front().size());
  KnowledgeRaster known({{0, 0}, resolution, columns, static_cast<int>(rows.size())});
  for (int row = 0; row < known.geometry.rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const std::string_view line = rows[rows.size() - 1 - static_cast<std::size_t>(row)];
      const char mark = line[static_cast<std::size_t>(column)];
      known[{column, row}] = mark == '?'   ? CellState::Unknown
                             : mark == '.' ? CellState::Free
                                           : CellState::Occupied;
    }
  }
  return known;
}

TEST(Frontiers, AreThePiecesOfFreeCellsBesideTheUnknown) {
  const KnowledgeRaster known = known_as({"..#????",  //
                                          "..#????",  //
                                          "....???",  //
                                          "....???",  //
                                          "##.####",  //
                                          "??.????"});
  const std::vector<Frontier> frontiers = frontiers_of(known);
  ASSERT_EQ(frontiers.size(), 2U);
  EXPECT_EQ(frontiers[0].cells, (std::vector<Cell>{{2, 0}}));
  EXPECT_EQ(frontiers[1].cells, (std::vector<Cell>{{3, 2}, {3, 3}}));
  EXPECT_EQ(frontiers[1].centroid, (Vec2{3.5, 3.0}));
  EXPECT_EQ(frontiers_of(known, 2).size(), 1U);
}

TEST(Frontiers, HangTogetherOverCorners) {
  const KnowledgeRaster known = known_as({".???",  //
                                          "..??",  //
                                          "...?"});
  ASSERT_EQ(frontiers_of(known).size(), 1U);
  EXPECT_EQ(frontiers_of(known)[0].cells, (std::vector<Cell>{{2, 0}, {1, 1}, {0, 2}}));
}

TEST(Frontiers, TheNearestIsNearestByWayNotByAir) {
  const KnowledgeRaster known = known_as({"?....",  //
                                          "#.##.",  //
                                          "...#.",  //
                                          "...#?"});
  const auto next = nearest_frontier(known, {2.5, 0.5});
  ASSERT_TRUE(next);
  EXPECT_EQ(next->frontier.cells, (std::vector<Cell>{{1, 3}}));
  EXPECT_EQ(next->path.points.front(), (Vec2{2.5, 0.5}));
  EXPECT_EQ(next->path.points.back(), (Vec2{1.5, 3.5}));
  EXPECT_NEAR(next->path.length, 2 + std::sqrt(2.0), 1e-12);
}

TEST(Frontiers, SayWhenNothingIsLeftOrTheRobotIsNowhere) {
  EXPECT_EQ(nearest_frontier(known_as({"..."}), {0.5, 0.5}).error(), NoPath::Unreachable);
  EXPECT_EQ(nearest_frontier(known_as({".#.?"}), {0.5, 0.5}).error(), NoPath::Unreachable);
  EXPECT_EQ(nearest_frontier(known_as({".?."}), {1.5, 0.5}).error(), NoPath::StartBlocked);
  EXPECT_EQ(nearest_frontier(known_as({".?."}), {9.5, 0.5}).error(), NoPath::StartOutside);
  ExplorationSettings wide;
  wide.radius = 0.7;
  EXPECT_EQ(nearest_frontier(known_as({"###", "..?", "###"}), {0.5, 1.5}, wide).error(),
            NoPath::StartBlocked);
}

const std::vector<std::string_view> kMaze{
    "#####################",  //
    "#...#.....#.........#",  //
    "#.#.#.###.#.#######.#",  //
    "#.#...#.#...#.....#.#",  //
    "#.#####.#####.###.#.#",  //
    "#.#.....#.....#.#.#.#",  //
    "#.#.###.#.#####.#.#.#",  //
    "#...#.....#.....#...#",  //
    "#####.#####.#########",  //
    "#.....#...#.........#",  //
    "#.#####.#.#########.#",  //
    "#.......#...........#",  //
    "#####################",
};

/// Notes what a robot at `place` sees: all around it up to three cells away, walls by standing
/// beside a cell that it sees.
void look_around(const BlockedRaster& maze, Cell place, KnowledgeRaster& known) {
  constexpr int kSight = 3;
  for (int up = -kSight; up <= kSight; ++up) {
    for (int right = -kSight; right <= kSight; ++right) {
      const Cell cell{place.column + right, place.row + up};
      if (!maze.geometry.contains(cell) || !is_free_line(maze, place, cell)) continue;
      known[cell] = CellState::Free;
      for (const Cell step : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}}) {
        const Cell beside{cell.column + step.column, cell.row + step.row};
        if (maze.geometry.contains(beside) && maze[beside] != 0) {
          known[beside] = CellState::Occupied;
        }
      }
    }
  }
}

TEST(Frontiers, LeadAnExplorerThroughAWholeMaze) {
  const BlockedRaster maze = test::drawn(kMaze);
  const mapping::GridGeometry& grid = maze.geometry;
  for (const Cell start : {Cell{1, 1}, Cell{19, 11}, Cell{7, 9}}) {
    KnowledgeRaster known(grid);
    Cell robot = start;
    double way = 0.0;
    int visits = 0;
    look_around(maze, robot, known);
    for (auto next = nearest_frontier(known, grid.centre_of(robot)); next;
         next = nearest_frontier(known, grid.centre_of(robot))) {
      ASSERT_TRUE(test::is_clear(maze, next->path.points));
      way += next->path.length;
      robot = grid.cell_at(next->path.points.back());
      look_around(maze, robot, known);
      ASSERT_LT(++visits, 120);  // a cell is visited once at most
    }
    const Vec2 from = grid.centre_of(start);
    const DistanceField field = wavefront(maze, {&from, 1});
    int covered = 0;
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const Cell cell{column, row};
        if (std::isinf(field[cell])) {
          EXPECT_NE(known[cell], CellState::Free);
        } else {
          EXPECT_EQ(known[cell], CellState::Free) << column << ", " << row;
          ++covered;
        }
      }
    }
    EXPECT_EQ(covered, 120);
    // A walk along every corridor and back, which no way through them all exceeds twice.
    EXPECT_LT(way, 2.0 * covered);
  }
}

TEST(Frontiers, KeepARobotOfSomeRadiusOffTheWalls) {
  const BlockedRaster maze = test::drawn(kMaze, 0.3);
  // Three cells where one was: corridors 0.3 m wide, in cells of 0.1 m.
  BlockedRaster fine({{0, 0}, 0.1, 3 * maze.geometry.columns, 3 * maze.geometry.rows});
  for (int row = 0; row < fine.geometry.rows; ++row) {
    for (int column = 0; column < fine.geometry.columns; ++column) {
      fine[{column, row}] = maze[{column / 3, row / 3}];
    }
  }
  KnowledgeRaster known(fine.geometry);
  Cell robot{4, 4};
  ExplorationSettings settings;
  settings.radius = 0.12;
  look_around(fine, robot, known);
  int visits = 0;
  for (auto next = nearest_frontier(known, fine.geometry.centre_of(robot), settings); next;
       next = nearest_frontier(known, fine.geometry.centre_of(robot), settings)) {
    for (const Vec2 point : next->path.points) {
      ASSERT_GE(test::nearest_square(fine, point), settings.radius);
    }
    robot = fine.geometry.cell_at(next->path.points.back());
    look_around(fine, robot, known);
    ASSERT_LT(++visits, 1100);
  }
  int missed = 0;
  for (std::size_t i = 0; i < fine.cells.size(); ++i) {
    if (fine.cells[i] == 0 && known.cells[i] != CellState::Free) ++missed;
  }
  EXPECT_EQ(missed, 0);
}

}  // namespace
}  // namespace eyebridge::planning
