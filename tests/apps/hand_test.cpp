// `--drive hand`, as a user types it. What a person then does is tested in tests/hal/hand_*.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"
#include "eyebridge/camera/png.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::ScratchFolder;

const std::string kHandMaze = EYEBRIDGE_SOURCE_DIR "/worlds/maze-5.maz";

ProgramRun run_hand(const std::vector<std::string>& flags, const ScratchFolder& folder,
                    const std::string& program = "/bin/true") {
  std::vector<std::string> words = {"run"};
  words.insert(words.end(), flags.begin(), flags.end());
  words.push_back(program);
  return testing::run_command(words, folder.path());
}

struct Wrong {
  const char* name;
  std::vector<std::string> flags;
  const char* place;
  const char* message;
};
void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

class HandRefused : public ::testing::TestWithParam<Wrong> {};

TEST_P(HandRefused, BeforeAnythingIsStarted) {
  const ScratchFolder folder;
  folder.write("open.wld", "floor 2000 2000\n");
  const ProgramRun r = run_hand(GetParam().flags, folder);
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_EQ(r.out, "");
  EXPECT_THAT(r.err, HasSubstr(std::string("eyebridge: ") + GetParam().place + ": "));
  EXPECT_THAT(r.err, HasSubstr(GetParam().message));
  EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << "one message: " << r.err;
}

INSTANTIATE_TEST_SUITE_P(
    Reasons, HandRefused,
    ::testing::Values(
        Wrong{
            "ABadText", {"--drive", "feet"}, "--drive", "found 'feet', expected hand or hand:free"},
        Wrong{"ABoard",
              {"--drive", "hand", "--hal", "serial:/dev/none", "--world", kHandMaze},
              "--drive",
              "found a person to drive 'serial:/dev/none', expected a simulated robot: --hal sim"},
        Wrong{"NoWorld",
              {"--drive", "hand", "--camera", "pattern"},
              "--drive",
              "found no world, expected --world with the maze that you walk in"},
        Wrong{"ARenderNobodyAskedFor",
              {"--drive", "hand", "--world", kHandMaze},
              "default",
              "found 'render' with --drive hand, expected a camera that sees the real maze"},
        Wrong{"ARender",
              {"--drive", "hand", "--world", kHandMaze, "--camera", "render:egl"},
              "--camera",
              "found 'render:egl' with --drive hand"},
        Wrong{"NoCamera",
              {"--drive", "hand", "--world", kHandMaze, "--camera", "none"},
              "--camera",
              "found 'none' with --drive hand"},
        Wrong{"ACameraThatIsNone",
              {"--drive", "hand", "--world", kHandMaze, "--camera", "film"},
              "--camera",
              "\"film\" is not known"},
        Wrong{
            "NoWalls",
            {"--drive", "hand", "--world", "open.wld", "--camera", "pattern"},
            "--drive",
            "found no wall in open.wld that a marker fits on, expected walls to put markers up on"},
        Wrong{"ALiveCameraInVirtualTime",
              {"--drive", "hand", "--world", kHandMaze, "--camera", "v4l2:/dev/video0", "--fast"},
              "--camera",
              "v4l2 gives frames in real time and the robot lives in virtual time"},
        Wrong{
            "OtherMotors",
            {"--drive", "hand", "--world", kHandMaze, "--camera", "pattern", "--mix", "motor=sim"},
            "--drive",
            "found a person and a motor under mix, expected one to drive"}),
    [](const auto& test) { return test.param.name; });

TEST(HandCommand, WithoutAnyMarkerSensorsFailAndSayWhy) {
  const ScratchFolder folder;
  const ProgramRun r =
      run_hand({"--drive", "hand", "--world", kHandMaze, "--camera", "pattern", "--fast"}, folder,
               EYEBRIDGE_TEST_LOST);
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "psd -1\nmotor 1\nstop 0\nwait 1\nframe 0\n");
  EXPECT_THAT(r.err,
              HasSubstr("hand: lost: show me a marker (the camera has seen no marker yet)\n"));
  EXPECT_THAT(r.err, HasSubstr("PSDGet: the camera has seen no marker yet"));
  EXPECT_THAT(r.err, HasSubstr("the camera is not calibrated: its angle of view is taken to be"));
}

TEST(HandCommand, FreeOfMarkersTheRobotDrivesAndItsWayIsShown) {
  const ScratchFolder folder;
  const ProgramRun r =
      run_hand({"--drive", "hand:free", "--fast", "--out", "out"}, folder, EYEBRIDGE_SQUARE);
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "back at 0 0, 0 deg\n");
  EXPECT_THAT(r.err, HasSubstr("hand: forward 0.40 m at 0.20 m/s\n"));
  EXPECT_THAT(r.err, HasSubstr("hand: turn left 90 deg at 90 deg/s\n"));
  EXPECT_EQ(camera::read_png(folder.path() + "/out/hand.png").width, 640);
}

}  // namespace
}  // namespace eyebridge
