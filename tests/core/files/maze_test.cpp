#include <gmock/gmock.h>

#include "eyebridge/base/units.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

std::vector<Warning> maze_warnings;

world::WorldModel maze_of(const std::string& text) {
  maze_warnings.clear();
  return read_maze(text, "m.maz", maze_warnings);
}

std::string maze_error(const std::string& text) {
  return error_of([&] { maze_of(text); });
}

// A 2 x 2 maze with a wall between its lower cells.
const std::string kSmall = " ___\n|r  |\n|_|S|\n500\n";

TEST(Maze, ReadsWallsAndStartsByTheColumnRule) {
  const auto maze = maze_of(kSmall);
  EXPECT_EQ(maze.width, 1.0);
  EXPECT_EQ(maze.height, 1.0);
  ASSERT_TRUE(maze.maze);
  EXPECT_EQ(maze.maze->south, (std::vector<char>{1, 1, 0, 0, 1, 1}));
  EXPECT_EQ(maze.maze->west, (std::vector<char>{1, 1, 1, 1, 0, 1}));
  EXPECT_EQ(maze.walls, world::walls_of(*maze.maze));
  ASSERT_EQ(maze.starts.size(), 2u);
  EXPECT_EQ(maze.starts[0], (world::StartPose{'r', {0.25, 0.75, 0}}));
  EXPECT_EQ(maze.starts[1], (world::StartPose{'S', {0.75, 0.25, kPi / 2}}));
  EXPECT_TRUE(maze_warnings.empty());
}

TEST(Maze, ACellIs360MillimetresUnlessSaid) { EXPECT_EQ(maze_of(" _\n|_|\n").maze->cell, 0.36); }

TEST(Maze, ToleratesTheSizeOnTheFirstLineWithAWarning) {
  EXPECT_EQ(maze_of("720\n _\n|_|\n").maze->cell, 0.72);
  ASSERT_EQ(maze_warnings.size(), 1u);
  EXPECT_EQ(maze_warnings[0].where.line, 1);
}

TEST(Maze, LettersFaceTheirWayAndOnlyUpperCaseHasAWall) {
  const auto maze = maze_of(" _________\n|u|D|L|r|s|\n");
  ASSERT_EQ(maze.starts.size(), 5u);
  const double angles[] = {kPi / 2, -kPi / 2, kPi, 0, kPi / 2};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(maze.starts[i].pose.theta, angles[i]) << i;
  EXPECT_EQ(std::vector<char>(maze.maze->south.begin(), maze.maze->south.begin() + 5),
            (std::vector<char>{0, 1, 1, 0, 0}));
}

TEST(Maze, PlacesBallsAndCrates) {
  const auto maze = maze_of(" ___\n|o|X|\n");
  ASSERT_EQ(maze.objects.size(), 2u);
  EXPECT_EQ(maze.objects[0].kind, world::ObjectKind::Ball);
  EXPECT_EQ(maze.objects[0].name, "golf");
  EXPECT_EQ(maze.objects[1].name, "crate");
  EXPECT_EQ(maze.objects[1].pose, (Pose{0.54, 0.18, 0}));
  EXPECT_EQ(maze.maze->south[0], 0);
  EXPECT_EQ(maze.maze->south[1], 1);
}

TEST(Maze, WarnsOfMisalignedBarsAndDashes) {
  const auto maze = maze_of(" ___\n| | |\n|_ ||\n");
  ASSERT_EQ(maze_warnings.size(), 2u) << "the boundary is open, too";
  EXPECT_EQ(maze_warnings[0].str(),
            "m.maz:3:4: warning: '|' in an even column, taken for one in the column after it: "
            "walls stand in odd "
            "columns");
  EXPECT_EQ(maze.maze->west, (std::vector<char>{1, 0, 1, 1, 1, 1}));
  const auto dash = maze_of(" ___\n|   |\n| _ |\n");
  ASSERT_EQ(maze_warnings.size(), 2u) << "the boundary is open, too";
  EXPECT_EQ(maze_warnings[0].where.column, 3);
  EXPECT_EQ(dash.maze->south, (std::vector<char>{1, 0, 0, 0, 1, 1}));
  maze_of(" ___\n|   |\n_  _|\n");
  EXPECT_EQ(maze_warnings.size(), 2u);
}

TEST(Maze, MisalignedBarsStandWhereEyeSimPutsThem) {
  const auto maze = maze_of(" ______\n|  | | |\n|S_____|\n");
  EXPECT_EQ(maze_warnings.size(), 5u) << "and an open boundary";
  EXPECT_EQ(maze.maze->columns, 4);
  EXPECT_EQ(maze.maze->west, (std::vector<char>{1, 0, 0, 0, 1, 1, 0, 1, 1, 1}));
}

TEST(Maze, MisalignedWallsGiveWayToWhatStandsInTheirPlace) {
  // One character can draw a robot or a wall, not both: the maze could not be written again.
  for (const std::string& text :
       {std::string(" ___\n|   |\n|_||S|\n"), std::string(" ___\n|  |o|\n|___|\n"),
        std::string(" ___\n|   |\n|s_ |\n"), std::string(" ___\n|o_ |\n|___|\n")}) {
    const auto maze = maze_of(text);
    ASSERT_GE(maze_warnings.size(), 1u) << text;
    EXPECT_THAT(maze_warnings[0].text, testing::HasSubstr("is ignored")) << text;
    EXPECT_EQ(maze_of(write_maze(maze)), maze) << text;
  }
}

TEST(Maze, WarnsOfLettersWithoutMeaningButNotOfDots) {
  maze_of(" ___\n|.F.|\n|___|\n");
  ASSERT_EQ(maze_warnings.size(), 1u);
  EXPECT_EQ(maze_warnings[0].where, (SourceLocation{"m.maz", 2, 3}));
}

TEST(Maze, ReadsADrawingWithThreeColumnsACell) {
  // The same maze as kSmall; letters stand in either column of a cell.
  const auto usual = maze_of(kSmall);
  std::vector<SourceLocation> places;
  for (const std::string& text : {std::string(" _____\n|r    |\n|__|S_|\n500\n"),
                                  std::string(" _____\n| r   |\n|__|_S|\n500\n")}) {
    const auto wide = maze_of(text);
    EXPECT_EQ(wide, usual) << text;
    ASSERT_EQ(maze_warnings.size(), 1u) << text;
    EXPECT_EQ(maze_warnings[0].where, (SourceLocation{"m.maz", 1, 1}));
    EXPECT_THAT(maze_warnings[0].text, testing::HasSubstr("drawn with three columns a cell"));
    EXPECT_EQ(maze_of(write_maze(wide)), wide);
  }
  read_maze(" _____\n| r   |\n|__|_S|\n", "m.maz", maze_warnings, &places);
  EXPECT_EQ(places, (std::vector<SourceLocation>{{"m.maz", 2, 3}, {"m.maz", 3, 6}}));
}

TEST(Maze, AFewMisplacedBarsDoNotMakeADrawingWide) {
  EXPECT_EQ(maze_of(" ___\n|  |\n|_|_|\n").maze->columns, 2);
  EXPECT_EQ(maze_of(" _____\n|_|_|_|\n").maze->columns, 3);
}

TEST(Maze, EveryMistakeIsNamed) {
  EXPECT_EQ(maze_error(""), "m.maz:1:1: no maze in the file: expected one drawn with '|' and '_'");
  EXPECT_EQ(maze_error("360\n"),
            "m.maz:1:1: no maze in the file: expected one drawn with '|' and '_'");
  EXPECT_EQ(maze_error("hello\nworld\n"),
            "m.maz:1:1: no wall in the maze: expected '|' in odd and '_' in even columns");
  EXPECT_EQ(maze_error(" _\n|\t|\n"),
            "m.maz:2:2: tab found: expected blanks, a tab has no width in a drawing");
  EXPECT_EQ(maze_error(" _\n|_|\n0\n"),
            "m.maz:3:1: the size of a cell is 0: expected 10 to 100000");
  EXPECT_EQ(maze_error("|\n"),
            "m.maz:1:1: no cell in the maze: expected at least two lines of two "
            "columns drawn with '|' and '_'");
}

TEST(Maze, LimitsTheNumberOfCells) {
  std::string text = std::string(60000, '_') + "\n";
  for (int i = 0; i < 20; ++i) text += "|\n";
  EXPECT_THAT(maze_error(text),
              testing::HasSubstr("30000 x 20 cells: expected at most 262144 cells"));
}

TEST(Maze, ReadWriteReadIsTheIdentity) {
  for (const std::string& text :
       {kSmall, std::string("   _\n  |o|\n _| |_\n|X    l|\n 180.5\n"),
        std::string(" ___ \n\n|_|\n"), std::string("  s\n|u  r\n  o  \n|\n_\n 7 \n36")}) {
    const auto first = maze_of(text);
    const std::string written = write_maze(first);
    EXPECT_EQ(maze_of(written), first) << text << "became\n" << written;
    EXPECT_EQ(write_maze(maze_of(written)), written);
  }
}

TEST(Maze, RefusesToDrawWhatAMazeCannotHold) {
  auto maze = maze_of(kSmall);
  maze.starts[0].pose.x += 0.01;
  EXPECT_THAT(error_of([&] { write_maze(maze); }), testing::HasSubstr("cannot draw all of it"));
  maze = maze_of(kSmall);
  maze.maze.reset();
  EXPECT_THAT(error_of([&] { write_maze(maze); }), testing::HasSubstr("it is no maze"));
  maze = maze_of(kSmall);
  maze.starts.push_back(maze.starts[0]);
  EXPECT_THAT(error_of([&] { write_maze(maze); }), testing::HasSubstr("two things"));
}

}  // namespace
}  // namespace eyebridge::files
