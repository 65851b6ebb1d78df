#include <filesystem>

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

constexpr const char* kMaze = " _ _\n|   |\n|S|_|\n";

ProgramRun run_camera(const ScratchFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "camera");
  return run_command(arguments, folder.path());
}

TEST(CameraMarkers, WritesAPdfAndSaysHowManyThereAre) {
  const ScratchFolder folder;
  folder.write("small.maz", kMaze);
  const ProgramRun r =
      run_camera(folder, {"markers", "--world", "small.maz", "--out", "sheet.pdf"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  // 8 edges of the boundary from inside, one wall from both sides.
  EXPECT_THAT(r.out, HasSubstr("sheet.pdf: 10 fiducials on 6 pages"));
}

TEST(CameraMarkers, WritesAPageAsAPicture) {
  const ScratchFolder folder;
  folder.write("small.maz", kMaze);
  const ProgramRun r = run_camera(folder, {"markers", "--world", "small.maz", "--out", "page.png",
                                           "--page", "2", "--size", "6cm"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(camera::read_png(folder.path() + "/page.png").width, 1260);
}

struct BadCall {
  const char* name;
  std::vector<std::string> arguments;
  const char* message;
};
void PrintTo(const BadCall& bad, std::ostream* out) { *out << bad.name; }

class CameraBadCall : public ::testing::TestWithParam<BadCall> {};

TEST_P(CameraBadCall, IsOneClearMessage) {
  const ScratchFolder folder;
  folder.write("small.maz", kMaze);
  folder.write("bare.wld", "floor 2000 1000\n");
  const ProgramRun r = run_camera(folder, GetParam().arguments);
  EXPECT_EQ(r.exit_code, 2) << r.out;
  EXPECT_THAT(r.err, HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Calls, CameraBadCall,
    ::testing::Values(
        BadCall{"NoWorld", {"markers", "--world", "none.wld", "--out", "a.pdf"}, "none.wld"},
        BadCall{
            "NoWalls", {"markers", "--world", "bare.wld", "--out", "a.pdf"}, "bare.wld: has no"},
        BadCall{
            "NoPdf", {"markers", "--world", "small.maz", "--out", "a.txt"}, "--out: found a.txt"},
        BadCall{"NoPage",
                {"markers", "--world", "small.maz", "--out", "a.png", "--page", "9"},
                "--page: found 9"},
        BadCall{"NoLength",
                {"markers", "--world", "small.maz", "--out", "a.pdf", "--size", "big"},
                "--size: found 'big'"},
        BadCall{"TooLarge",
                {"markers", "--world", "small.maz", "--out", "a.pdf", "--size", "1m"},
                "--size: found '1m'"},
        BadCall{"AFamilyThatThereIsNot",
                {"markers", "--world", "small.maz", "--out", "a.pdf", "--family", "tag"},
                "--family: found 'tag', expected aruco, tag36h11, tag25h9 or tag16h5"},
        BadCall{"NoCamera", {"calibrate", "--out", "a.toml"}, "--camera"},
        BadCall{"NoOutput", {"calibrate", "--camera", "pattern"}, "--out"},
        BadCall{"NoBoard",
                {"calibrate", "--camera", "pattern", "--out", "a.toml", "--board", "circles"},
                "--board: found 'circles'"},
        BadCall{
            "UnknownCamera", {"calibrate", "--camera", "webcam", "--out", "a.toml"}, "--camera"},
        BadCall{"Calibrated",
                {"calibrate", "--camera", "pattern?calibration=b.toml", "--out", "a.toml"},
                "found a calibration"},
        BadCall{"BoardTooLarge",
                {"calibrate", "--print", "a.pdf", "--board", "charuco:12x7"},
                "do not fit"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(CameraCalibrate, PrintsTheBoard) {
  const ScratchFolder folder;
  const ProgramRun r = run_camera(folder, {"calibrate", "--print", "board.png"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(camera::read_png(folder.path() + "/board.png").height, 1782);
}

TEST(CameraCalibrate, ACameraThatShowsNoBoardGivesNoCalibration) {
  const ScratchFolder folder;
  const ProgramRun r = run_camera(
      folder, {"calibrate", "--camera", "pattern", "--out", "cam.toml", "--seconds", "1"});
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_THAT(r.err, HasSubstr("no calibration: found 0 different views"));
  EXPECT_THAT(r.err, HasSubstr("1 s are over"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/cam.toml"));
}

}  // namespace
}  // namespace eyebridge
