// Files of others as they lie in their folders, by load_scenario(); and what we write, read again.
#include "eyebridge/files/foreign_worlds.hpp"

#include <gmock/gmock.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/mapping/ground_truth.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

const std::string kPublicMaps = EYEBRIDGE_SHARED_DIR "/data/maps/";
const std::string kPublicMazes = EYEBRIDGE_SHARED_DIR "/data/mazes/";

Scenario load_bare(const std::filesystem::path& path) {
  LoadOptions options;
  options.robot.clear();
  return load_scenario(path, options);
}

std::vector<std::string> in_words(const std::vector<Warning>& warnings) {
  std::vector<std::string> out;
  for (const Warning& warning : warnings) out.push_back(warning.str());
  return out;
}

TEST(PublicFiles, AWorldOfStageWithItsPicture) {
  const Scenario read = load_bare(kPublicMaps + "lse_arena.world");
  // floorplan ( size [4.0 3.0 1.00] pose [-1.5 2.0 0 90.000] boundary 1 ): turned, it is 3 x 4 m.
  EXPECT_NEAR(read.world.width, 3, 1e-9);
  EXPECT_NEAR(read.world.height, 4, 1e-9);
  EXPECT_NEAR(read.world.corner.x, -3, 1e-9);
  EXPECT_NEAR(read.world.corner.y, 0, 1e-9);
  ASSERT_EQ(read.world.starts.size(), 1U);
  EXPECT_EQ(read.world.starts[0].pose, (Pose{-1, 1, 0}));
  EXPECT_GT(read.world.walls.size(), 20U);
  EXPECT_THAT(in_words(read.warnings), Contains(HasSubstr("lse_arena.pgm': read")));
  // A pixel of the picture is 50 mm; its column c and row r lie at (-3 + r * 0.05, c * 0.05).
  const GreyPicture picture =
      read_map_picture(read_bytes(kPublicMaps + "lse_arena.pgm", "a picture"), "lse_arena.pgm");
  const auto truth = mapping::truth_of(read.world, {.resolution = 0.05});
  int walls = 0;
  int wrong = 0;
  for (int row = 1; row < picture.rows - 1; ++row) {
    for (int column = 1; column < picture.columns - 1; ++column) {
      const auto is_dark = [&](int x, int y) {
        return picture.greys[static_cast<std::size_t>(y * picture.columns + x)] <= 127;
      };
      if (!is_dark(column, row)) continue;
      ++walls;
      bool found = false;
      for (const double dx : {-0.05, 0.0, 0.05}) {
        for (const double dy : {-0.05, 0.0, 0.05}) {
          const Vec2 place{-3 + (row + 0.5) * 0.05 + dx, (column + 0.5) * 0.05 + dy};
          found = found || truth.state(place) == mapping::CellState::Occupied;
        }
      }
      const bool is_inside = is_dark(column - 1, row) && is_dark(column + 1, row) &&
                             is_dark(column, row - 1) && is_dark(column, row + 1);
      wrong += found || is_inside ? 0 : 1;
    }
  }
  EXPECT_GT(walls, 50);
  EXPECT_EQ(wrong, 0);
}

TEST(PublicFiles, EveryContestMazeIsReadWithoutAWarning) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kPublicMazes)) {
    const Scenario read = load_bare(entry.path());
    ASSERT_TRUE(read.world.maze) << entry.path();
    EXPECT_TRUE(read.warnings.empty()) << entry.path() << ": " << read.warnings[0].str();
    EXPECT_FALSE(read.world.maze->goals.empty()) << entry.path();
    EXPECT_EQ(read.world.starts.size(), 1U) << entry.path();
    // Written with posts and read again it is the same maze.
    std::vector<Warning> warnings;
    const WrittenWorld posts = write_maze_as(MazeFormat::Posts, read.world);
    EXPECT_EQ(read_maze(posts.text, "again", warnings).maze, read.world.maze) << entry.path();
    ++count;
  }
  EXPECT_EQ(count, 39);
}

/// Cells of 10 mm that hold a wall, of a world that was written and read again.
double agreement_after(const Scenario& scenario, const std::string& name, const std::string& text) {
  const Folder folder;
  const Scenario again = load_bare(folder.write(name, text));
  const auto before = mapping::truth_of(scenario.world, {.resolution = 0.01});
  const mapping::GridGeometry& g = before.geometry();
  const auto after = mapping::truth_of(again.world, {.resolution = 0.01});
  std::size_t walls = 0;
  std::size_t found = 0;
  for (int row = 0; row < g.rows; ++row) {
    for (int column = 0; column < g.columns; ++column) {
      if (before.state(mapping::Cell{column, row}) != mapping::CellState::Occupied) continue;
      ++walls;
      bool near = false;
      for (const double dx : {-0.01, 0.0, 0.01}) {
        for (const double dy : {-0.01, 0.0, 0.01}) {
          near = near || after.state(g.centre_of({column, row}) + Vec2{dx, dy}) ==
                             mapping::CellState::Occupied;
        }
      }
      found += near ? 1 : 0;
    }
  }
  return static_cast<double>(found) / static_cast<double>(walls);
}

TEST(PublicFiles, OurWorldsSurviveEveryFormat) {
  for (const std::string name : {"rooms.wld", "slalom.wld", "maze-5.maz", "micromouse-16.maz"}) {
    const Scenario scenario = load_bare(EYEBRIDGE_SOURCE_DIR "/worlds/" + name);
    EXPECT_EQ(agreement_after(scenario, "w.svg", write_svg(scenario, "w").text), 1.0) << name;
    EXPECT_EQ(agreement_after(scenario, "w.world", write_stage(scenario, "w").text), 1.0) << name;
  }
}

}  // namespace
}  // namespace eyebridge::files
