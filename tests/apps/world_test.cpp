#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"
#include "eyebridge/camera/png.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_command;
using testing::ScratchFolder;

constexpr const char* kRoom =
    "floor 2000 1000\n0 0 2000 0\n0 1000 2000 1000\n0 0 0 1000\n2000 0 2000 1000\n";
constexpr const char* kSmallMaze = " _ _\n|   |\n|S|_|\n";

TEST(WorldCheck, SaysWhatIsInAWorld) {
  const ScratchFolder folder;
  folder.write("room.wld", kRoom);
  const ProgramRun r = run_command({"world", "check", "room.wld"}, folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("room.wld: 2 m x 1 m, 4 walls, 0 objects, 0 warnings\n"));
}

TEST(WorldCheck, SaysHowManyCellsAMazeHas) {
  const ScratchFolder folder;
  folder.write("small.maz", kSmallMaze);
  const ProgramRun r = run_command({"world", "check", "small.maz"}, folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("small.maz: 0.72 m x 0.72 m, 2 x 2 cells of 0.36 m"));
}

TEST(WorldCheck, GoesOnAfterABadFile) {
  const ScratchFolder folder;
  folder.write("room.wld", kRoom);
  const ProgramRun r = run_command({"world", "check", "missing.wld", "room.wld"}, folder.path());
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_THAT(r.err, HasSubstr("missing.wld"));
  EXPECT_THAT(r.out, HasSubstr("room.wld: 2 m x 1 m"));
}

TEST(WorldConvert, WritesFormatsAndListsWhatTheyCannotSay) {
  const ScratchFolder folder;
  folder.write("m.maz", " _ _\n|x g|\n|S|_|\n360\n");
  const ProgramRun posts = run_command({"world", "convert", "m.maz", "m.txt"}, folder.path());
  EXPECT_EQ(posts.exit_code, 0) << posts.err;
  EXPECT_EQ(testing::file_text(folder.path() + "/m.txt"),
            "o---o---o\n|     G |\no   o   o\n| S |   |\no---o---o\n360\n");
  EXPECT_THAT(posts.err, HasSubstr("m.txt: warning: not carried over: the crate at 180 540 mm"));
  const ProgramRun again = run_command({"world", "convert", "m.maz", "m.txt"}, folder.path());
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.err, HasSubstr("is there already: expected another name, or --overwrite"));
  const ProgramRun other = run_command({"world", "convert", "m.maz", "m.pdf"}, folder.path());
  EXPECT_THAT(other.err, HasSubstr("expected .maz, .txt, .num, .wld, .svg, .sdf, .world, .yaml"));
}

TEST(WorldConvert, MovesAMapToWhereAWorldBegins) {
  const ScratchFolder folder;
  const ProgramRun r = run_command(
      {"world", "convert", EYEBRIDGE_SHARED_DIR "/cases/maps/lab.yaml", "lab.wld"}, folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.err, HasSubstr("where its floor begins: all is moved by 1200 800 mm"));
  const ProgramRun check = run_command({"world", "check", "lab.wld"}, folder.path());
  EXPECT_THAT(check.out, HasSubstr("lab.wld: 2.4 m x 1.6 m, 12 walls, 0 objects, 0 warnings\n"));
}

TEST(WorldConvert, MapsHaveTheirPictureBesideThem) {
  const ScratchFolder folder;
  folder.write("room.wld", kRoom);
  const ProgramRun r = run_command(
      {"world", "convert", "--resolution", "20mm", "room.wld", "m.yaml"}, folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "m.pgm\nm.yaml\n");
  const ProgramRun check = run_command({"world", "check", "m.yaml"}, folder.path());
  EXPECT_THAT(check.out, HasSubstr("m.yaml: 2.04 m x 1.04 m"));
  const ProgramRun again = run_command({"world", "convert", "room.wld", "m.yaml"}, folder.path());
  EXPECT_EQ(again.exit_code, 2);
  const ProgramRun fine =
      run_command({"world", "convert", "--resolution", "1um", "room.wld", "n.yaml"}, folder.path());
  EXPECT_EQ(fine.exit_code, 2);
  EXPECT_THAT(fine.err, HasSubstr("--resolution"));
}

TEST(WorldConvert, FormatsOfOthersCarryOverWalls) {
  const ScratchFolder folder;
  folder.write("room.wld", kRoom);
  for (const std::string to : {"m.svg", "m.world"}) {
    const ProgramRun r = run_command({"world", "convert", "room.wld", to}, folder.path());
    EXPECT_EQ(r.exit_code, 0) << r.err;
    const ProgramRun check = run_command({"world", "check", to}, folder.path());
    EXPECT_EQ(check.exit_code, 0) << check.err;
    EXPECT_THAT(check.out, HasSubstr(", 4 walls, 0 objects, ")) << to;
  }
}

struct BadFile {
  const char* name;
  const char* file;
  std::string text;
  const char* place;
};
void PrintTo(const BadFile& bad, std::ostream* out) { *out << bad.name; }

class WorldCheckOfABadFile : public ::testing::TestWithParam<BadFile> {};

TEST_P(WorldCheckOfABadFile, IsOneClearMessage) {
  const ScratchFolder folder;
  folder.write(GetParam().file, GetParam().text);
  const ProgramRun r = run_command({"world", "check", GetParam().file}, folder.path());
  EXPECT_EQ(r.exit_code, 2) << r.out;
  EXPECT_THAT(r.err, HasSubstr(GetParam().place));
  EXPECT_EQ(r.out, "");
  EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
}

INSTANTIATE_TEST_SUITE_P(
    Files, WorldCheckOfABadFile,
    ::testing::Values(BadFile{"Empty", "a.wld", "", "a.wld"},
                      BadFile{"EmptyMaze", "a.maz", "", "a.maz"},
                      BadFile{"BinaryJunk", "a.wld",
                              std::string("\x7f"
                                          "ELF\0\1\2\xff\xfe",
                                          9),
                              "a.wld"},
                      BadFile{"UnknownKeyword", "a.wld", "floor 1000 1000\nhedge 1 2 3 4\n",
                              "a.wld:2:1"},
                      BadFile{"PopWithoutPush", "a.wld", "floor 1000 1000\npop\n", "a.wld:2:1"},
                      BadFile{"WallOfNoLength", "a.wld", "floor 1000 1000\n5 5 5 5\n", "a.wld:2:1"},
                      BadFile{"NotANumber", "a.wld", "floor 1000 1000\n0 nan 5 5\n", "a.wld:2:3"},
                      BadFile{"UnknownEnding", "a.xyz", "floor 1000 1000\n", "a.xyz"}),
    [](const auto& bad) { return std::string(bad.param.name); });

TEST(WorldDraw, WritesAPictureInTheShapeOfTheWorld) {
  const ScratchFolder folder;
  folder.write("room.wld", kRoom);
  const ProgramRun r = run_command({"world", "draw", "room.wld"}, folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "room.png\n");
  const camera::Frame picture = camera::read_png(folder.path() + "/room.png");
  EXPECT_EQ(picture.width, 1000);
  EXPECT_GT(picture.height, 480);
  EXPECT_LT(picture.height, 600);
}

TEST(WorldDraw, TakesANameAndASize) {
  const ScratchFolder folder;
  folder.write("room.wld", kRoom);
  const ProgramRun r =
      run_command({"world", "draw", "room.wld", "-o", "other.png", "--size", "300"}, folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(camera::read_png(folder.path() + "/other.png").width, 300);
}

TEST(WorldDraw, APictureThatCannotBeWrittenIsAFailure) {
  const ScratchFolder folder;
  folder.write("room.wld", kRoom);
  const ProgramRun r =
      run_command({"world", "draw", "room.wld", "-o", "no/such/folder.png"}, folder.path());
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_THAT(r.err, HasSubstr("no/such/folder.png"));
}

TEST(Output, ThatDoesNotArriveIsAFailure) {
  for (const char* words : {"world list", "--version", "config"}) {
    const auto r = testing::run_program(
        {{"sh", "-c", EYEBRIDGE_BIN "/eyebridge " + std::string(words) + " >/dev/full"}, {}, {}});
    EXPECT_EQ(r.exit_code, 1) << words;
    EXPECT_THAT(r.err, ::testing::HasSubstr("could not be written in full")) << words;
  }
}

}  // namespace
}  // namespace eyebridge
