// Worlds that are named, not given by a path: in every command that takes one.
#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;
using testing::run_command;

constexpr const char* kSmallRoom =
    "; A small room.\nfloor 2000 1000\n0 0 2000 0\n0 1000 2000 1000\n0 0 0 1000\n"
    "2000 0 2000 1000\n";

class WorldNames : public ::testing::Test {
 protected:
  WorldNames() {
    std::filesystem::create_directories(path("home/eyebridge/worlds"));
    std::filesystem::create_directories(path("bin/worlds"));
  }
  std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
  ProgramRun run(const std::vector<std::string>& words,
                 std::map<std::string, std::string> environment = {}) const {
    environment["XDG_DATA_HOME"] = path("home");
    return run_command(words, folder_.path(), environment);
  }

  const testing::ScratchFolder folder_;
  const std::string installed_ = EYEBRIDGE_BUILD_DIR "/share/eyebridge/worlds";
};

TEST_F(WorldNames, AreFoundFromFlagsVariablesAndFiles) {
  const std::string expected = "world +=  *" + installed_ + "/rooms.wld +# ";
  EXPECT_THAT(run({"config", "--world", "rooms.wld"}).out, ContainsRegex(expected + "--world"));
  EXPECT_THAT(run({"config"}, {{"EYEBRIDGE_WORLD", "rooms.wld"}}).out,
              ContainsRegex(expected + "EYEBRIDGE_WORLD"));
  folder_.write("eyebridge.toml", "world = 'rooms.wld'\n");
  EXPECT_THAT(run({"config"}).out, ContainsRegex(expected + "eyebridge.toml:1:9"));
}

TEST_F(WorldNames, TheFolderOfASettingsFileComesFirst) {
  std::filesystem::create_directories(path("settings/eyebridge"));
  folder_.write("settings/eyebridge/eyebridge.toml", "world = 'rooms.wld'\n");
  const std::map<std::string, std::string> settings = {{"XDG_CONFIG_HOME", path("settings")}};
  EXPECT_THAT(run({"config"}, settings).out, HasSubstr("= " + installed_ + "/rooms.wld"));
  folder_.write("home/eyebridge/worlds/rooms.wld", kSmallRoom);
  EXPECT_THAT(run({"config"}, settings).out,
              HasSubstr("= " + path("home/eyebridge/worlds/rooms.wld")));
  folder_.write("settings/eyebridge/rooms.wld", kSmallRoom);
  EXPECT_THAT(run({"config"}, settings).out,
              HasSubstr("= " + path("settings/eyebridge/rooms.wld")));
}

TEST_F(WorldNames, OneBesideTheProgramIsItsOwn) {
  folder_.write("bin/worlds/own.wld", kSmallRoom);
  std::filesystem::copy_file(EYEBRIDGE_SQUARE, path("bin/square"));
  const ProgramRun r =
      run({"run", "--fast", "--time-limit", "1s", "--world", "own.wld", "bin/square"});
  EXPECT_THAT(r.err, Not(HasSubstr("no file")));
  EXPECT_EQ(r.exit_code, 0) << r.err;
}

TEST_F(WorldNames, EveryCommandFindsThem) {
  const ProgramRun checked = run({"world", "check", "rooms.wld"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_THAT(checked.out, HasSubstr("rooms.wld: 4 m x 4 m"));
  EXPECT_EQ(run({"world", "draw", "maze-8.maz", "-o", "maze.png"}).exit_code, 0);
  EXPECT_EQ(run({"camera", "markers", "--world", "maze-8.maz", "--out", "maze.pdf"}).exit_code, 0);
  EXPECT_EQ(run({"firmware", "--world", "two-robots.sim", "--hdt"}).exit_code, 0);
}

TEST_F(WorldNames, OneThatIsMissingIsAnsweredWithTheNearest) {
  const auto expect_hint = [&](const std::vector<std::string>& words, const std::string& hint) {
    const ProgramRun r = run(words);
    EXPECT_EQ(r.exit_code, 2) << r.out;
    EXPECT_THAT(r.err, HasSubstr(hint));
  };
  expect_hint({"run", "--fast", "--world", "Rooms.wld", EYEBRIDGE_SQUARE},
              "--world: no file 'Rooms.wld': expected 'rooms.wld' (only the case differs); looked "
              "in the working folder, ");
  expect_hint({"assess", "--worlds", "maze-6.maz", EYEBRIDGE_SQUARE},
              "--worlds: no file 'maze-6.maz': expected 'maze-5.maz' or 'maze-8.maz'; looked in");
  expect_hint({"sweep", "--world", "romms.wld", EYEBRIDGE_SQUARE},
              "--world: no file 'romms.wld': expected 'rooms.wld'; looked in");
  expect_hint({"world", "check", "corridor"}, "no file 'corridor': expected 'corridor.wld'");
  folder_.write("a.sim", "world rooms.wdl\n");
  expect_hint(
      {"world", "check", "a.sim"},
      "a.sim:1:7: no file 'rooms.wdl': expected 'rooms.wld'; looked in the working folder, ");
}

TEST_F(WorldNames, AreListedByTheirPlace) {
  folder_.write("here.wld", kSmallRoom);
  folder_.write("bad.wld", "flor 1 1\n");
  folder_.write("home/eyebridge/worlds/mine.sim",
                "# Mine.\nworld empty-room.wld\nS4 500 500 0\n"
                "S4 1500 1500 0\n");
  folder_.write("home/eyebridge/worlds/rooms.wld", kSmallRoom);
  folder_.write("bin/worlds/own.wld", kSmallRoom);
  const ProgramRun r = run({"world", "list", "--program", "bin/square"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(
      r.out,
      AllOf(HasSubstr("Working folder: " + folder_.path() + "\n"),
            ContainsRegex("\n  bad.wld +cannot be read +/.*/bad.wld:1:1: "),
            ContainsRegex("\n  here.wld +2 m x 1 m +A small room.\n"),
            HasSubstr("\nBeside the program: " + path("bin/worlds") + "\n  own.wld"),
            HasSubstr("\nYours: " + path("home/eyebridge/worlds") + "\n"),
            ContainsRegex("\n  mine.sim +2 m x 2 m, 2 robots +Mine.\n"),
            HasSubstr("\nInstalled: " + installed_ + "\n"),
            ContainsRegex("\n  maze-5.maz +1.8 m x 1.8 m, 5 x 5 cells of 0.36 m\n"),
            ContainsRegex("\n  rooms.wld +4 m x 4 m +hidden by the world of this name above\n"),
            ContainsRegex("\n  two-robots.sim +4 m x 4 m, 2 robots +Two kinds of robot")));
}

TEST_F(WorldNames, APlaceWithoutWorldsSaysSo) {
  const ProgramRun r = run({"world", "list"});
  EXPECT_THAT(r.out, HasSubstr("Working folder: " + folder_.path() + "\n  no worlds\nYours: "));
}

TEST_F(WorldNames, EveryInstalledWorldButAMazeHasADescription) {
  const ProgramRun r = run({"world", "list"});
  const std::string installed = r.out.substr(r.out.find("\nInstalled: "));
  std::istringstream lines(installed.substr(1));
  std::string line;
  std::getline(lines, line);
  int count = 0;
  for (; std::getline(lines, line); ++count) {
    EXPECT_THAT(line, Not(HasSubstr("cannot be read")));
    if (line.find(".maz ") == std::string::npos) {
      EXPECT_THAT(line, ContainsRegex(" [A-Z].*[a-z]"));
    }
  }
  EXPECT_GT(count, 15);
}

}  // namespace
}  // namespace eyebridge
