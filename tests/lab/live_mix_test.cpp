// A camera of the kernel's own beside simulated robots, as a user runs it. Needs /dev/video0 to be
// one (vivid): the lab runs it.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/camera/png.hpp"
#include "run_program.hpp"

namespace eyebridge {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;

const fs::path kSource = EYEBRIDGE_SOURCE_DIR;

ProgramRun run(std::vector<std::string> words, const std::string& folder) {
  words.insert(words.begin(), {EYEBRIDGE_BIN "/eyebridge", "run"});
  return testing::run_program({words, {{"XDG_CONFIG_HOME", "/dev/null/none"}}, folder});
}

TEST(LiveMix, ASimulatedRobotSeesThroughALiveCamera) {
  const testing::ScratchFolder place;
  const fs::path folder = fs::path(place.path()) / "examples/mixtures/live-camera";
  fs::create_directories(folder);
  fs::copy(kSource / "examples/mixtures/live-camera/eyebridge.toml", folder);
  fs::create_directory_symlink(kSource / "worlds", place.path() + "/worlds");
  const ProgramRun r =
      run({"--time-limit", "3s", "--out", "out", EYEBRIDGE_COLOUR_FOLLOWER}, folder.string());
  EXPECT_THAT(r.err, HasSubstr("results in out")) << r.out;
  EXPECT_THAT(r.err, Not(HasSubstr("CAMGet")));
  const camera::Frame first = camera::read_png(folder / "out/frames/0000.png");
  EXPECT_EQ(first.width, 160);
  EXPECT_NE(first.bytes, camera::read_png(folder / "out/frames/0010.png").bytes) << "it lives";
}

TEST(LiveMix, ARobotInTheHandIsLostWhereNoMarkerIs) {
  const testing::ScratchFolder folder;
  const ProgramRun r =
      run({"--drive", "hand", "--camera", "v4l2:/dev/video0", "--world",
           (kSource / "worlds/maze-5.maz").string(), "--out", "out", EYEBRIDGE_TEST_LOST},
          folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "psd -1\nmotor 1\nstop 0\nwait 1\nframe 0\n") << r.err;
  EXPECT_THAT(r.err, HasSubstr("PSDGet: the camera has seen no marker yet"));
  EXPECT_TRUE(fs::exists(folder.path() + "/out/hand.png"));
}

TEST(LiveMix, ALiveCameraInVirtualTimeIsRefused) {
  const testing::ScratchFolder folder;
  const ProgramRun r = run({"--fast", "--drive", "hand", "--camera", "v4l2:/dev/video0", "--world",
                            (kSource / "worlds/maze-5.maz").string(), EYEBRIDGE_TEST_LOST},
                           folder.path());
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_EQ(r.out, "");
  EXPECT_THAT(r.err, HasSubstr("virtual time"));
}

}  // namespace
}  // namespace eyebridge
