// The maze explorer against mazes that nobody here drew: does it find the way that a flood fill of
// the file finds?

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/files/readers.hpp"
#include "maze_reach.hpp"
#include "run_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;

world::WorldModel read(const std::string& file) {
  std::vector<Warning> warnings;
  return files::read_maze(files::read_maze_file(file), file, warnings);
}

testing::ProgramRun explore(const std::string& file) {
  return testing::run_program(
      {{EYEBRIDGE_MAZE_EXPLORER},
       {{"EYEBRIDGE_FAST", "true"}, {"EYEBRIDGE_ROBOT", "Mouse"}, {"EYEBRIDGE_WORLD", file}},
       ""});
}

/// Mazes that cannot be solved as a contest's, and why.
constexpr const char* kBareStart = "no wall to the left and right of the start cell";
const std::map<std::string, std::string> kNotForContests = {
    {"vr-maze", kBareStart},    {"vr-maze1", kBareStart},    {"vr-rect4", kBareStart},
    {"vr-square1", kBareStart}, {"vr-square10", kBareStart}, {"vr-square2", kBareStart},
    {"vr-square5", kBareStart},
};

std::string folder() { return std::string(EYEBRIDGE_SHARED_DIR) + "/data/worlds/maz/"; }

/// All published mazes with a start letter.
std::vector<std::string> mazes() {
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(folder(), missing)) {
    const std::string name = entry.path().stem().string();
    if (!read(entry.path().string()).starts.empty() && !kNotForContests.contains(name)) {
      names.push_back(name);
    }
  }
  std::ranges::sort(names);
  return names;
}

class PublishedMaze : public ::testing::TestWithParam<std::string> {};

TEST_P(PublishedMaze, IsSolvedByTheShortestWay) {
  const std::string file = folder() + GetParam() + ".maz";
  const world::WorldModel model = read(file);
  const MazeReach reached(model);
  ASSERT_FALSE(reached.is_open());
  ASSERT_TRUE(reached.way_to_centre()) << "the centre of this maze cannot be reached";

  const testing::ProgramRun r = explore(file);

  EXPECT_EQ(r.exit_code, 0) << r.out << r.err;
  EXPECT_THAT(r.out, HasSubstr(fmt::format("path length: {} cells", *reached.way_to_centre())));
  EXPECT_THAT(r.out, HasSubstr("maze solved\n"));
}

INSTANTIATE_TEST_SUITE_P(Contest, PublishedMaze, ::testing::ValuesIn(mazes()),
                         [](const auto& maze) {
                           std::string name = maze.param;
                           for (char& c : name) {
                             if (c == '-' || c == '~') c = '_';
                           }
                           return name;
                         });

/// Mazes of contests, as micromouseonline/mazefiles keeps them.
std::vector<std::string> contest_mazes() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(EYEBRIDGE_SHARED_DIR) + "/data/mazes/")) {
    names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

class MazeOfAContest : public ::testing::TestWithParam<std::string> {};

TEST_P(MazeOfAContest, EndsAtItsOwnCentreOrHasNone) {
  const std::string file = std::string(EYEBRIDGE_SHARED_DIR) + "/data/mazes/" + GetParam() + ".txt";
  const world::WorldModel model = read(file);
  const MazeReach reached(model);
  ASSERT_FALSE(reached.is_open());
  const testing::ProgramRun r = testing::run_program(
      {{EYEBRIDGE_MAZE_EXPLORER, "20", std::to_string(model.maze->columns),
        std::to_string(model.maze->rows)},
       {{"EYEBRIDGE_FAST", "true"}, {"EYEBRIDGE_ROBOT", "Mouse"}, {"EYEBRIDGE_WORLD", file}},
       ""});
  const auto way = reached.way_to_own_centre();
  EXPECT_EQ(r.exit_code, way ? 0 : 1) << r.out << r.err;
  EXPECT_THAT(r.out, HasSubstr(way ? fmt::format("path length: {} cells", *way)
                                   : "the centre cannot be reached"));
}

INSTANTIATE_TEST_SUITE_P(Contest, MazeOfAContest, ::testing::ValuesIn(contest_mazes()),
                         [](const auto& maze) {
                           std::string name = maze.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(PublishedMazes, ThatAreNoContestMazesAreThere) {
  for (const auto& [name, reason] : kNotForContests) {
    EXPECT_TRUE(std::filesystem::exists(folder() + name + ".maz")) << name << ": " << reason;
  }
}

TEST(OwnMaze, IsSolvedByTheShortestWay) {
  const std::string file = std::string(EYEBRIDGE_SOURCE_DIR) + "/worlds/micromouse-16.maz";
  const world::WorldModel model = read(file);
  const testing::ProgramRun r = explore(file);
  EXPECT_EQ(r.exit_code, 0) << r.out << r.err;
  EXPECT_THAT(r.out, HasSubstr(fmt::format("path length: {} cells",
                                           MazeReach(model).way_to_centre().value())));
}

TEST(ContestMaze, WithAStartThatIsOpenToASideIsExplored) {
  const testing::ProgramRun r =
      explore(std::string(EYEBRIDGE_SHARED_DIR) + "/cases/mazes/side-opening.maz");
  EXPECT_EQ(r.exit_code, 0) << r.out << r.err;
  EXPECT_THAT(r.out, HasSubstr("cells of 180 mm\n"));
  EXPECT_THAT(r.out, HasSubstr("cells seen: 14\n"));  // two have walls on all sides
}

TEST(ContestMaze, EndsAtItsOwnCentreAlsoWhereCellsCannotBeReached) {
  // The right column is shut: of what can be reached the middle is elsewhere.
  const testing::ScratchFolder folder;
  const std::string maze = folder.write("shut.txt",
                                        "o---o---o---o---o\n"
                                        "|           |   |\n"
                                        "o   o---o   o   o\n"
                                        "|   |       |   |\n"
                                        "o   o   o---o   o\n"
                                        "|   |       |   |\n"
                                        "o   o---o   o   o\n"
                                        "| S |       |   |\n"
                                        "o---o---o---o---o\n");
  const testing::ProgramRun told = testing::run_program(
      {{EYEBRIDGE_MAZE_EXPLORER, "20", "4"},
       {{"EYEBRIDGE_FAST", "true"}, {"EYEBRIDGE_ROBOT", "Mouse"}, {"EYEBRIDGE_WORLD", maze}},
       ""});
  EXPECT_EQ(told.exit_code, 0) << told.out << told.err;
  EXPECT_THAT(told.out, HasSubstr("path length: 6 cells"));  // to (2, 2)
}

TEST(ContestMaze, WithoutAWayOutIsNotSolved) {
  const testing::ScratchFolder folder;
  const testing::ProgramRun r =
      explore(folder.write("cell.txt", "+---+---+\n| S |   |\n+---+---+\n"));
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_THAT(r.out, HasSubstr("no way out of the start cell"));
  EXPECT_THAT(r.out, ::testing::Not(HasSubstr("maze solved")));
}

TEST(OpenMaze, IsGivenUp) {
  const testing::ScratchFolder folder;
  const testing::ProgramRun r = explore(folder.write("open.maz", "\n| |\n|S|\n180\n"));
  EXPECT_EQ(r.exit_code, 1) << r.out << r.err;
  EXPECT_THAT(r.out, HasSubstr("gave up: more than 4096 cells seen"));
}

}  // namespace
}  // namespace eyebridge
