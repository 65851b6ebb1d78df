#include <cstdlib>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;

std::string world(const std::string& name) {
  return std::string(EYEBRIDGE_SOURCE_DIR) + "/worlds/" + name;
}

ProgramRun run(const std::string& program, const std::string& world_name,
               std::map<std::string, std::string> settings = {}) {
  settings["EYEBRIDGE_FAST"] = "true";
  settings["EYEBRIDGE_WORLD"] = world(world_name);
  return testing::run_program({{program}, settings, ""});
}

TEST(Square, EndsWhereItStarted) {
  const ProgramRun r = run(EYEBRIDGE_SQUARE, "empty-room.wld");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "back at 0 0, 0 deg\n");
}

TEST(WallFollower, KeepsItsDistanceToTheWall) {
  const testing::ScratchFolder folder;
  const ProgramRun r =
      run(EYEBRIDGE_WALL_FOLLOWER, "empty-room.wld", {{"EYEBRIDGE_OUT", folder.path()}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  // Columns: t, x, y, theta, linear, angular, three of odometry, then the PSDs: front, left, …
  std::istringstream trace(testing::file_text(folder.path() + "/trace.csv"));
  std::string line;
  std::getline(trace, line);
  int rows = 0;
  int near_the_wall = 0;
  while (std::getline(trace, line)) {
    std::vector<double> column;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) column.push_back(std::stod(cell));
    ASSERT_GE(column.size(), 12U);
    if (column[0] < 20) continue;
    ++rows;
    near_the_wall += column[10] > 0.08 && column[10] < 0.35 ? 1 : 0;
  }
  ASSERT_GT(rows, 400);
  EXPECT_GT(near_the_wall, rows * 8 / 10);
}

TEST(ColourFollower, FindsTheRedThing) {
  const ProgramRun r = run(EYEBRIDGE_COLOUR_FOLLOWER, "colour-targets.sim");
  EXPECT_EQ(r.exit_code, 0) << r.out << r.err;
  EXPECT_THAT(r.out, HasSubstr("found it"));
}

}  // namespace
}  // namespace eyebridge
