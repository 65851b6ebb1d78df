// The maze explorer against mazes that nobody here drew: does it find the way that a flood fill of
// the file finds?

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <filesystem>
#include <optional>

#include "eyebridge/files/readers.hpp"
#include "run_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;

/// Length in cells of the shortest way from the first start letter to the middle of the maze.
std::optional<int> shortest_way(const world::WorldModel& model) {
  const world::MazeGrid& maze = *model.maze;
  const auto index = [&](int x, int y) { return static_cast<std::size_t>(y * maze.columns + x); };
  const auto open = [&](int x, int y, int dx, int dy) {
    if (dx != 0) {
      return maze.west[static_cast<std::size_t>(y * (maze.columns + 1) + x + (dx > 0 ? 1 : 0))] == 0;
    }
    return maze.south[static_cast<std::size_t>((y + (dy > 0 ? 1 : 0)) * maze.columns + x)] == 0;
  };
  std::vector<int> distance(index(0, maze.rows), -1);
  const Pose start = model.starts.at(0).pose;
  std::deque<std::pair<int, int>> queue{
      {static_cast<int>(start.x / maze.cell), static_cast<int>(start.y / maze.cell)}};
  distance[index(queue[0].first, queue[0].second)] = 0;
  while (!queue.empty()) {
    const auto [x, y] = queue.front();
    queue.pop_front();
    const int here = distance[index(x, y)];
    const auto middle = [](int at, int size) { return at >= (size - 1) / 2 && at <= size / 2; };
    if (middle(x, maze.columns) && middle(y, maze.rows)) return here;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
      const int nx = x + dx;
      const int ny = y + dy;
      if (nx < 0 || ny < 0 || nx >= maze.columns || ny >= maze.rows) continue;
      if (!open(x, y, dx, dy) || distance[index(nx, ny)] >= 0) continue;
      distance[index(nx, ny)] = here + 1;
      queue.emplace_back(nx, ny);
    }
  }
  return std::nullopt;
}

testing::ProgramRun explore(const std::string& file) {
  return testing::run_program({{EYEBRIDGE_MAZE_EXPLORER},
                               {{"EYEBRIDGE_FAST", "true"},
                                {"EYEBRIDGE_ROBOT", "Mouse"},
                                {"EYEBRIDGE_WORLD", file}},
                               ""});
}

class CompetitionMaze : public ::testing::TestWithParam<const char*> {};

TEST_P(CompetitionMaze, IsSolvedByTheShortestWay) {
  const std::string file =
      std::string(EYEBRIDGE_SHARED_DIR) + "/data/worlds/maz/" + GetParam() + ".maz";
  std::vector<Warning> warnings;
  const auto model = files::read_maze(files::read_text_file(file), file, warnings);
  const std::optional<int> way = shortest_way(model);
  ASSERT_TRUE(way) << "the centre of this maze cannot be reached";

  const testing::ProgramRun r = explore(file);

  EXPECT_EQ(r.exit_code, 0) << r.out << r.err;
  EXPECT_THAT(r.out, HasSubstr("path length: " + std::to_string(*way) + " cells"));
  EXPECT_THAT(r.out, HasSubstr("maze solved\n"));
}

INSTANTIATE_TEST_SUITE_P(Published, CompetitionMaze,
                         ::testing::Values("vr-apec-1990", "vr-chicago-1986", "vr-japan-1982",
                                           "vr-london-1986", "vr-size-example", "vr-maze2"),
                         [](const auto& maze) {
                           std::string name = maze.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(OwnMaze, IsSolvedByTheShortestWay) {
  const std::string file = std::string(EYEBRIDGE_SOURCE_DIR) + "/worlds/micromouse-16.maz";
  std::vector<Warning> warnings;
  const auto model = files::read_maze(files::read_text_file(file), file, warnings);
  const testing::ProgramRun r = explore(file);
  EXPECT_EQ(r.exit_code, 0) << r.out << r.err;
  EXPECT_THAT(r.out, HasSubstr("path length: " + std::to_string(shortest_way(model).value()) +
                               " cells"));
}

}  // namespace
}  // namespace eyebridge
