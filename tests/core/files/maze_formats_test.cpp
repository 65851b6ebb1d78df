// Mazes as contests and other simulators keep them: the same maze in each format, and what is odd
// in one.
#include <algorithm>
#include <array>
#include <random>

#include <gmock/gmock.h>

#include "eyebridge/base/units.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

using world::MazeCell;

const std::string kMazeCases = EYEBRIDGE_SHARED_DIR "/cases/mazes/";

struct ReadMaze {
  world::WorldModel model;
  std::vector<std::string> warnings;
};

ReadMaze read_it(const std::string& bytes, std::optional<double> cell = std::nullopt) {
  std::vector<Warning> warnings;
  ReadMaze out{read_maze(bytes, "m", warnings, nullptr, cell), {}};
  for (const Warning& warning : warnings) out.warnings.push_back(warning.str());
  return out;
}

std::string refusal(const std::string& bytes) {
  return error_of([&] { read_it(bytes); });
}

// 3 x 2 cells, as the pages of two simulators draw and list it.
const std::string kPlus =
    "+---+---+---+\n"
    "|       |   |\n"
    "+   +   +   +\n"
    "|   |       |\n"
    "+---+---+---+\n";
const std::string kList =
    "0 0 0 1 1 1\n0 1 1 0 0 1\n1 0 0 0 1 1\n1 1 1 1 0 0\n2 0 0 1 1 0\n2 1 1 1 0 1\n";
const std::string kDrawing = " _ _ _\n|   | |\n|_|_ _|\n180\n";

TEST(MazeFormats, TheSameMazeInEachHasTheSameWalls) {
  const auto plus = read_it(kPlus);
  const auto list = read_it(kList);
  const auto drawing = read_it(kDrawing);
  EXPECT_THAT(plus.warnings, testing::IsEmpty());
  EXPECT_THAT(list.warnings, testing::IsEmpty());
  EXPECT_EQ(plus.model, list.model);
  EXPECT_EQ(plus.model.walls, drawing.model.walls);
  EXPECT_EQ(plus.model.maze->cell, 0.18);
  EXPECT_EQ(plus.model.maze->goals, (std::vector<MazeCell>{{1, 0}, {1, 1}}));
  ASSERT_EQ(plus.model.starts.size(), 1u);
  EXPECT_EQ(plus.model.starts[0], (world::StartPose{'S', {0.09, 0.09, kPi / 2}}));
}

TEST(MazeFormats, PostsAreDrawnInManyWays) {
  const auto walls = read_it(kPlus).model.walls;
  for (const std::string& text : {
           std::string(
               "o---o---o---o\n|       |   |\no   o   o   o\n|   |       |\no---o---o---o\n"),
           std::string("+-+-+-+\n|   | |\n+ + + +\n| |   |\n+-+-+-+\n"),
           std::string(
               "\n  o--o--o--o\n  |     |  |\n  o  o  o  o\n  |  |     |\n  o--o--o--o\n\n"),
           std::string("+---+---+---+\n|       |   |\n|       |   |\n+   +   +   +\n|   |       |\n"
                       "|   |       |\n+---+---+---+\n"),
           std::string("+---+---+---+\r\n|       |   |\r\n+   +   +   +\r\n|   |       |\r\n"
                       "+---+---+---+"),
       }) {
    const auto maze = read_it(text);
    EXPECT_EQ(maze.model.walls, walls) << text;
    EXPECT_THAT(maze.warnings, testing::IsEmpty()) << text;
  }
}

TEST(MazeFormats, MarksAreStartsAndGoals) {
  const auto maze =
      read_it("o---o---o---o\n| G   R |   |\no   o   o   o\n| S |    GS |\no---o---o---o\n250\n");
  EXPECT_EQ(maze.model.maze->cell, 0.25);
  EXPECT_EQ(maze.model.maze->goals, (std::vector<MazeCell>{{2, 0}, {0, 1}}));
  ASSERT_EQ(maze.model.starts.size(), 3u);
  EXPECT_EQ(maze.model.starts[0], (world::StartPose{'R', {0.375, 0.375, 0}}));
  EXPECT_EQ(maze.model.starts[1], (world::StartPose{'S', {0.125, 0.125, kPi / 2}}));
  EXPECT_NEAR(read_it(kPlus, 0.3).model.width, 0.9, 1e-12) << "what is asked for goes before";
  EXPECT_NEAR(read_it(kDrawing, 0.3).model.width, 0.9, 1e-12);
}

TEST(MazeFormats, AStartFacesTheSideThatIsOpen) {
  EXPECT_EQ(read_it("+---+---+\n| S     |\n+---+---+\n").model.starts[0].pose.theta, 0.0);
  EXPECT_EQ(read_it("+---+---+\n|     S |\n+---+---+\n").model.starts[0].pose.theta, kPi);
  EXPECT_EQ(read_it("+---+\n| S |\n+   +\n|   |\n+---+\n").model.starts[0].pose.theta, -kPi / 2);
}

TEST(MazeFormats, WhatIsOddIsSaidWithItsPlace) {
  const auto warning = [](const std::string& text) {
    const auto warnings = read_it(text).warnings;
    return warnings.size() == 1 ? warnings[0] : "several: " + testing::PrintToString(warnings);
  };
  EXPECT_EQ(warning("+---+---+\n|   ?   |\n+---+---+\n"),
            "m:2:5: warning: '?' is taken for a wall: expected '|'");
  EXPECT_EQ(warning("+---+---+\n|   | x |\n+---+---+\n"),
            "m:2:7: warning: 'x' means nothing in a maze and is ignored: expected S or G");
  EXPECT_EQ(warning("+---+---+\n|       |\n+---*---+\n"),
            "m:3:5: warning: '*' where a post belongs");
  EXPECT_EQ(warning("+---+---+\n|       |\n+---+- -+\n"),
            "m:3:6: warning: a wall that is drawn in part is taken for a whole one");
  EXPECT_EQ(warning("+---+---+\n|       |\n+---+===+\n"),
            "m:3:6: warning: '=' is taken for a wall: expected '-'");
  EXPECT_EQ(warning("+---+---+\n|       |  a\n+---+---+\n"),
            "m:2:12: warning: 'a' outside of the drawing is ignored");
  EXPECT_EQ(warning("+---+---+\n|        \n+---+---+\n"),
            "m:2:9: warning: the outer boundary is open here: a robot can leave the maze");
  EXPECT_EQ(
      warning("+---+---+\n|        \n+---+   +\n"),
      "m:2:9: warning: the outer boundary is open here and at 1 more places: a robot can leave "
      "the maze");
  EXPECT_EQ(warning("o   o   o\n         \no   o   o\n"), "m:1:2: warning: a maze without walls");
  EXPECT_EQ(warning(" _ _\n|    \n|_ _|\n"),
            "m:2:5: warning: the outer boundary is open here: a robot can leave the maze");
  EXPECT_EQ(
      warning("0 0 1 1 1 1\n1 0 1 1 1 0\n"),
      "m:2:11: warning: no wall on this side of cell 1 0, but its neighbour has one: there is "
      "a wall");
}

TEST(MazeFormats, EveryMistakeIsNamed) {
  EXPECT_EQ(refusal("+---+---+\n|       |\n"),
            "m:2:1: no second line of posts below the first: expected a line of cells, then one of "
            "posts");
  EXPECT_EQ(refusal("+---+---+\n|       |\n+---+---+\n|   |   |\n"),
            "m:4:1: the drawing ends within a row of cells: expected a line of posts");
  EXPECT_EQ(refusal("0 0 1 1 1 1\n1 0 1\n"),
            "m:2:6: 3 words on a line: expected 'x y north east south west'");
  EXPECT_EQ(refusal("0 0 1 1 1 2\n"), "m:1:11: wall west is 2: expected 0 to 1");
  EXPECT_EQ(refusal("0 0 1 1 1 1\n0 0 1 1 1 1\n"),
            "m:2:1: cell 0 0 again, after line 1: expected it once");
  EXPECT_EQ(refusal("0 0 1 0 1 1\n1 1 1 1 1 0\n"),
            "m:3:1: file ends without cell 0 1: expected all 2 x 2");
}

TEST(MazeFormats, TheCasesAreRead) {
  if (!std::filesystem::exists(kMazeCases)) FAIL() << kMazeCases << " is not there";
  const auto posts = read_it(read_maze_file(kMazeCases + "posts.txt"));
  EXPECT_THAT(posts.warnings, testing::IsEmpty());
  EXPECT_EQ(posts.model.maze->columns, 4);
  EXPECT_EQ(posts.model.maze->rows, 4);
  EXPECT_EQ(posts.model.maze->goals, (std::vector<MazeCell>{{2, 2}}));
  const auto plus = read_it(read_maze_file(kMazeCases + "plus-posts.maz"));
  EXPECT_EQ(plus.model.walls, posts.model.walls);
  EXPECT_EQ(read_it(read_maze_file(kMazeCases + "list.num")).model.maze->columns, 2);
}

/// A maze of a contest: closed all around, the start as the rules want it.
world::MazeGrid contest(int side, std::mt19937& dice) {
  std::bernoulli_distribution wall(0.4);
  world::MazeGrid grid;
  grid.columns = grid.rows = side;
  grid.cell = 0.18;
  const auto n = static_cast<std::size_t>(side);
  for (std::size_t i = 0; i < n * (n + 1); ++i) {
    grid.south.push_back(i < n || i >= n * n || wall(dice));
    grid.west.push_back(i % (n + 1) == 0 || i % (n + 1) == n || wall(dice));
  }
  grid.south[n] = 0;  // above the start
  grid.west[1] = 1;   // right of it
  if (side < 3) return grid;
  // No other corner looks like one.
  grid.south[2 * n - 1] = grid.west[n - 1] = 0;
  grid.south[(n - 1) * n] = grid.west[(n - 1) * (n + 1) + 1] = 0;
  grid.south[n * n - 1] = grid.west[n * (n + 1) - 2] = 0;
  return grid;
}

bool has(const world::MazeGrid& grid, int column, int row, int side) {
  const int wide = grid.columns;
  switch (side) {
    case 0:
      return grid.south[static_cast<std::size_t>((row + 1) * wide + column)] != 0;
    case 1:
      return grid.west[static_cast<std::size_t>(row * (wide + 1) + column + 1)] != 0;
    case 2:
      return grid.south[static_cast<std::size_t>(row * wide + column)] != 0;
    default:
      return grid.west[static_cast<std::size_t>(row * (wide + 1) + column)] != 0;
  }
}

TEST(MazeFormats, BinaryIsReadWhateverTheOrderOfBitsAndCells) {
  std::mt19937 dice(7);
  for (int trial = 0; trial < 40; ++trial) {
    const int side = trial % 4 == 0 ? 32 : 16;
    const world::MazeGrid grid = contest(side, dice);
    std::array<unsigned, 4> bits = {1, 2, 4, 8};
    std::ranges::shuffle(bits, dice);
    const bool by_rows = dice() % 2 != 0;
    const bool from_top = dice() % 2 != 0;
    const bool ones_are_open = dice() % 2 != 0;
    std::string bytes(static_cast<std::size_t>(side * side), '\0');
    for (int column = 0; column < side; ++column) {
      for (int row = 0; row < side; ++row) {
        const int line = from_top ? side - 1 - row : row;
        unsigned byte = 0;
        for (int at = 0; at < 4; ++at) {
          if (has(grid, column, row, at) != ones_are_open)
            byte |= bits[static_cast<std::size_t>(at)];
        }
        bytes[static_cast<std::size_t>(by_rows ? line * side + column : column * side + line)] =
            static_cast<char>(byte);
      }
    }
    const auto maze = read_it(bytes);
    EXPECT_THAT(maze.warnings, testing::IsEmpty());
    EXPECT_EQ(maze.model.maze->south, grid.south) << trial;
    EXPECT_EQ(maze.model.maze->west, grid.west) << trial;
  }
}

TEST(MazeFormats, BytesThatAreNoMazeAreRefused) {
  std::mt19937 dice(7);
  std::string bytes(256, '\0');
  for (char& c : bytes) c = static_cast<char>(dice() % 256);
  EXPECT_THAT(refusal(bytes),
              testing::HasSubstr("256 bytes that are no maze: for no order of bits"));
  // A wall that one byte lacks is said, and is there.
  std::mt19937 other(8);
  const world::MazeGrid grid = contest(16, other);
  std::string good(256, '\0');
  for (int i = 0; i < 256; ++i) {
    for (int at = 0; at < 4; ++at) {
      if (has(grid, i / 16, i % 16, at))
        good[static_cast<std::size_t>(i)] |= static_cast<char>(1 << at);
    }
  }
  good[0] = static_cast<char>(good[0] & ~2);
  const auto maze = read_it(good);
  ASSERT_EQ(maze.warnings.size(), 1u);
  EXPECT_THAT(maze.warnings[0], testing::HasSubstr("1 walls that only one of their two cells has"));
  EXPECT_EQ(maze.model.maze->west, grid.west);
}

TEST(MazeFormats, WhatIsWrittenIsReadAgain) {
  std::mt19937 dice(9);
  for (int trial = 0; trial < 60; ++trial) {
    const auto model = read_it(write_maze_as(MazeFormat::List,
                                             [&] {
                                               world::WorldModel plain;
                                               plain.maze =
                                                   contest(1 + static_cast<int>(dice() % 20), dice);
                                               return plain;
                                             }())
                                   .text)
                           .model;
    for (const MazeFormat format : {MazeFormat::Posts, MazeFormat::List, MazeFormat::Drawing}) {
      const WrittenWorld written = write_maze_as(format, model);
      const auto again = read_it(written.text);
      if (written.losses.empty()) {
        EXPECT_EQ(again.model, model);
      } else {
        EXPECT_EQ(again.model.walls, model.walls);
      }
    }
    EXPECT_THAT(write_maze_as(MazeFormat::Posts, model).losses, testing::IsEmpty());
    EXPECT_THAT(write_maze_as(MazeFormat::List, model).losses, testing::IsEmpty());
  }
}

TEST(MazeFormats, WhatAFormatCannotSayIsListed) {
  const auto drawn = read_it(" _ _ _\n|S  |x|\n|_|_ _|\n");
  const auto posts = write_maze_as(MazeFormat::Posts, drawn.model);
  EXPECT_THAT(posts.losses,
              testing::ElementsAre("the crate at 900 540 mm", "the start 'S', which is 'U' now",
                                   "that there is no goal: it is the middle"));
  EXPECT_THAT(posts.text, testing::HasSubstr("\n360\n"));
  EXPECT_THAT(write_maze_as(MazeFormat::List, drawn.model).losses,
              testing::Contains("the size of its cells: --cell 360mm"));
  const auto right = read_it("+---+---+\n| S   G |\n+---+---+\n");
  const auto drawing = write_maze_as(MazeFormat::Drawing, right.model);
  EXPECT_THAT(drawing.losses,
              testing::ElementsAre("the start 'S', which is 'R' now, as it faces that way"));
  EXPECT_EQ(drawing.text, " _ _.\n|R G|\n180\n");
}

}  // namespace
}  // namespace eyebridge::files
