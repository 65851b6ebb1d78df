#include <deque>
#include <set>

#include <gmock/gmock.h>

#include "reading.hpp"

namespace eyebridge::files {
namespace {

const std::filesystem::path kWorlds = std::filesystem::path(EYEBRIDGE_SOURCE_DIR) / "worlds";

TEST(OwnWorlds, AllLoadWithoutWarnings) {
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kWorlds)) {
    if (!entry.is_regular_file() || entry.path().extension() == ".md") continue;
    // Only the robot that was made for it fits the cells of the contest.
    const bool contest = entry.path().filename() == "micromouse-16.maz";
    try {
      const auto scenario = load_scenario(entry.path(), {.robot = contest ? "Mouse" : "S4"});
      EXPECT_FALSE(scenario.robots.empty()) << entry.path();
      for (const Warning& warning : scenario.warnings) ADD_FAILURE() << warning.str();
    } catch (const ConfigError& error) {
      ADD_FAILURE() << error.what();
    }
    ++files;
  }
  EXPECT_GE(files, 14);
}

TEST(OwnWorlds, SurviveWritingAndReading) {
  for (const auto& entry : std::filesystem::directory_iterator(kWorlds)) {
    const std::string extension = entry.path().extension().string();
    std::vector<Warning> warnings;
    if (extension == ".wld") {
      const auto world = read_world(read_text_file(entry.path()), "a", warnings);
      EXPECT_EQ(read_world(write_world(world), "b", warnings), world) << entry.path();
    } else if (extension == ".maz") {
      const auto maze = read_maze(read_text_file(entry.path()), "a", warnings);
      EXPECT_EQ(read_maze(write_maze(maze), "b", warnings), maze) << entry.path();
    }
  }
}

/// The contest maze as cells 0 … 255 and the openings between them.
class Contest {
 public:
  Contest() {
    std::vector<Warning> warnings;
    model = read_maze(read_text_file(kWorlds / "micromouse-16.maz"), "m", warnings);
  }

  std::vector<int> neighbours(int cell) const {
    const int row = cell / 16;
    const int column = cell % 16;
    const auto& maze = *model.maze;
    const auto south = [&](int r) { return maze.south[static_cast<std::size_t>(r * 16 + column)]; };
    const auto west = [&](int c) { return maze.west[static_cast<std::size_t>(row * 17 + c)]; };
    std::vector<int> out;
    if (!south(row)) out.push_back(cell - 16);
    if (!south(row + 1)) out.push_back(cell + 16);
    if (!west(column)) out.push_back(cell - 1);
    if (!west(column + 1)) out.push_back(cell + 1);
    return out;
  }

  world::WorldModel model;
};

TEST(OwnWorlds, TheContestMazeKeepsTheRules) {
  const Contest contest;
  ASSERT_TRUE(contest.model.maze);
  EXPECT_EQ(contest.model.maze->columns, 16);
  EXPECT_EQ(contest.model.maze->rows, 16);
  EXPECT_EQ(contest.model.maze->cell, 0.18);
  ASSERT_EQ(contest.model.starts.size(), 1u);
  EXPECT_EQ(contest.model.starts[0].pose.position(), (Vec2{0.09, 0.09}));
  EXPECT_EQ(contest.neighbours(0), std::vector<int>{16});  // the start opens upwards only

  const std::set<int> goal = {7 * 16 + 7, 7 * 16 + 8, 8 * 16 + 7, 8 * 16 + 8};
  int inside = 0;
  int entrances = 0;
  for (const int cell : goal) {
    for (const int other : contest.neighbours(cell)) ++(goal.contains(other) ? inside : entrances);
  }
  EXPECT_EQ(inside, 8);  // no wall between the four
  EXPECT_EQ(entrances, 1);
}

TEST(OwnWorlds, TheContestMazeIsConnectedAndHasLoops) {
  const Contest contest;
  std::set<int> seen = {0};
  std::deque<int> queue = {0};
  std::size_t openings = 0;
  while (!queue.empty()) {
    const int cell = queue.front();
    queue.pop_front();
    for (const int other : contest.neighbours(cell)) {
      ++openings;
      if (seen.insert(other).second) queue.push_back(other);
    }
  }
  EXPECT_EQ(seen.size(), 256u);
  // A tree over 256 cells has 255 openings; the goal's own square is one loop.
  EXPECT_GE(openings / 2, 255u + 10u);
}

}  // namespace
}  // namespace eyebridge::files
