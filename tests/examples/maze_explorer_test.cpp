// The maze explorer against mazes that nobody here drew: does it find the way that a flood fill of
// the file finds?

#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/files/readers.hpp"
#include "run_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;

struct Cell {
  int x = 0;
  int y = 0;
};

/// Which cells of a maze can be reached from its first start letter, and how far they are.
class Reached {
 public:
  explicit Reached(const world::WorldModel& model)
      : maze_(*model.maze), distance_(index({0, maze_.rows}), -1) {
    const Pose start = model.starts.at(0).pose;
    std::deque<Cell> queue{
        {static_cast<int>(start.x / maze_.cell), static_cast<int>(start.y / maze_.cell)}};
    low_ = high_ = queue[0];
    distance_[index(queue[0])] = 0;
    for (; !queue.empty(); queue.pop_front()) visit(queue);
  }

  /// Nothing between the start and the world outside the maze.
  [[nodiscard]] bool is_open() const { return open_; }

  /// Length in cells of the shortest way to the middle of what can be reached.
  [[nodiscard]] std::optional<int> way_to_centre() const {
    std::optional<int> best;
    for (int y = (low_.y + high_.y) / 2; y <= (low_.y + high_.y + 1) / 2; ++y) {
      for (int x = (low_.x + high_.x) / 2; x <= (low_.x + high_.x + 1) / 2; ++x) {
        const int distance = distance_[index({x, y})];
        if (distance >= 0 && (!best || distance < *best)) best = distance;
      }
    }
    return best;
  }

 private:
  [[nodiscard]] std::size_t index(Cell c) const {
    return static_cast<std::size_t>(c.y * maze_.columns + c.x);
  }

  [[nodiscard]] bool can_pass(Cell c, int dx, int dy) const {
    const int x = c.x + (dx > 0 ? 1 : 0);
    const int y = c.y + (dy > 0 ? 1 : 0);
    return dx != 0 ? maze_.west[static_cast<std::size_t>(y * (maze_.columns + 1) + x)] == 0
                   : maze_.south[static_cast<std::size_t>(y * maze_.columns + x)] == 0;
  }

  void visit(std::deque<Cell>& queue) {
    const Cell here = queue.front();
    low_ = {std::min(low_.x, here.x), std::min(low_.y, here.y)};
    high_ = {std::max(high_.x, here.x), std::max(high_.y, here.y)};
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
      if (!can_pass(here, dx, dy)) continue;
      const Cell next{here.x + dx, here.y + dy};
      if (next.x < 0 || next.y < 0 || next.x >= maze_.columns || next.y >= maze_.rows) {
        open_ = true;
      } else if (distance_[index(next)] < 0) {
        distance_[index(next)] = distance_[index(here)] + 1;
        queue.push_back(next);
      }
    }
  }

  const world::MazeGrid& maze_;
  std::vector<int> distance_;
  Cell low_;
  Cell high_;
  bool open_ = false;
};

world::WorldModel read(const std::string& file) {
  std::vector<Warning> warnings;
  return files::read_maze(files::read_text_file(file), file, warnings);
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
  const Reached reached(model);
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
                                           Reached(model).way_to_centre().value())));
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
