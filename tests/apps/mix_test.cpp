// `--mix`, as a user types it: a board's wheels in a simulated world's corridor.
#include <csignal>
#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>

#include "command.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/camera/png.hpp"
#include "running_firmware.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_shell;
using testing::RunningFirmware;
using testing::ScratchFolder;

TEST(MixCommand, SimulatedSensorsSeeWhatABoardsWheelsDo) {
  const ScratchFolder folder;
  // The board is in a room of its own, far from any wall; the program's world has one ahead.
  const std::string open_field =
      folder.write("field.wld", "floor 9000 9000\nposition 4500 4500 0\n");
  folder.write("room.wld", "floor 4000 2000\n2000 0 2000 2000\nposition 1000 1000 0\n");
  folder.write("eyebridge.toml",
               "hal = 'serial:./eyebot.tty'\nworld = 'room.wld'\n[mix]\npsd = 'sim'\n");
  folder.write("prog.c",
               "#include \"eyebot.h\"\n#include <stdio.h>\n"
               "int main(void) {\n  printf(\"%d \", PSDGet(1));\n  VWStraight(300, 300);\n"
               "  VWWait();\n  printf(\"%d\\n\", PSDGet(1));\n  return 0;\n}\n");
  RunningFirmware board({"--world", open_field, "--pty", "./eyebot.tty"}, folder.path());
  EXPECT_EQ(board.hal(), "serial:./eyebot.tty");
  const ProgramRun r = run_shell(
      "eyebridge-cc prog.c -o prog\nunset EYEBRIDGE_FAST\neyebridge run ./prog\n", folder.path());
  ASSERT_EQ(r.exit_code, 0) << r.err;
  int before = 0;
  int after = 0;
  std::istringstream(r.out) >> before >> after;
  EXPECT_NEAR(before, 995 - 60, 1) << "an S4's front sensor sits 60 mm ahead of its centre";
  EXPECT_NEAR(before - after, 300, 15);
  EXPECT_EQ(board.finish(SIGTERM), 0);
}

/// The folder examples/mixtures/`name`, as if it lay in examples/mixtures/ of `place`, beside the
/// worlds; the path of that folder.
std::string put_example(const ScratchFolder& place, const std::string& name) {
  const std::filesystem::path source = EYEBRIDGE_SOURCE_DIR;
  const std::filesystem::path folder =
      std::filesystem::path(place.path()) / "examples/mixtures" / name;
  std::filesystem::create_directories(folder);
  std::filesystem::copy(source / "examples/mixtures" / name / "eyebridge.toml", folder);
  std::filesystem::create_directory_symlink(source / "worlds", place.path() + "/worlds");
  return folder.string();
}

TEST(MixExamples, ALiveCameraInASimulatedWorld) {
  // Instead of a webcam the test picture, whose red bar is found; the lab has real devices.
  const ScratchFolder place;
  const std::string folder = put_example(place, "live-camera");
  const ProgramRun r = testing::run_command({"run", "--fast", "--camera", "pattern", "--time-limit",
                                             "3s", "--out", "out", EYEBRIDGE_COLOUR_FOLLOWER},
                                            folder);
  EXPECT_THAT(r.err, HasSubstr("results in out")) << r.out;
  const camera::Frame seen = camera::read_png(folder + "/out/frames/0000.png");
  EXPECT_EQ(seen.row(10)[0], 255) << "the first bar is white";
  EXPECT_GT(camera::read_png(folder + "/out/map.png").width, 100) << "and there is a world";
}

TEST(MixExamples, ARenderedCameraOnABoard) {
  const ScratchFolder place;
  const std::string folder = put_example(place, "board-in-a-rendered-world");
  RunningFirmware board(
      {"--world", EYEBRIDGE_SOURCE_DIR "/worlds/colour-targets.sim", "--pty", "./eyebot.tty"},
      folder);
  EXPECT_EQ(board.hal(), "serial:./eyebot.tty");
  const ProgramRun r = testing::run_command({"run", EYEBRIDGE_COLOUR_FOLLOWER}, folder);
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("found it"));
  const Pose end = board.stop();
  EXPECT_LT(norm(end.position() - Vec2{1.5, 1.3}), 0.3) << "the real robot stands before the can";
}

TEST(MixExamples, ARecordedCameraWithASimulatedDrive) {
  const ScratchFolder place;
  const std::string folder = put_example(place, "recorded-camera");
  const ProgramRun recorded = testing::run_command(
      {"run", "--fast", "--camera", "render", "--record", "walk.ebrec", EYEBRIDGE_COLOUR_FOLLOWER},
      folder);
  ASSERT_EQ(recorded.exit_code, 0) << recorded.err;
  const ProgramRun again =
      testing::run_command({"run", "--fast", EYEBRIDGE_COLOUR_FOLLOWER}, folder);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(again.out, recorded.out) << "the same pictures, the same drive";
}

TEST(MixCommand, BadMixesAreRefusedBeforeAnythingIsStarted) {
  const ScratchFolder folder;
  for (const auto& [mix, message] : {std::pair{"wings=sim", "found 'wings' as a device"},
                                     {"psd=moon", "unknown backend 'moon'"},
                                     {"psd", "found no backend for 'psd'"},
                                     {"psd=sim:x", "expected sim alone"}}) {
    const ProgramRun r = testing::run_command({"run", "--mix", mix, "/bin/true"}, folder.path());
    EXPECT_EQ(r.exit_code, 2);
    EXPECT_THAT(r.err, HasSubstr("--mix"));
    EXPECT_THAT(r.err, HasSubstr(message));
  }
}

}  // namespace
}  // namespace eyebridge
