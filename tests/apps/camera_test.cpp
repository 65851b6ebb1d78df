// `eyebridge camera show` and `camera record`, as a user types them.

#include <algorithm>
#include <csignal>
#include <filesystem>

#include <gmock/gmock.h>

#include "command.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/picture.hpp"
#include "eyebridge/camera/png.hpp"
#include "eyebridge/camera/recording/frame_table.hpp"
#include "running_program.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_command;
using testing::RunningProgram;
using testing::ScratchFolder;

class CameraCommand : public ::testing::Test {
 protected:
  ProgramRun camera(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "camera");
    return run_command(arguments, folder_.path());
  }
  void expect_bad_input(const std::vector<std::string>& arguments, const std::string& message) {
    const ProgramRun r = camera(arguments);
    EXPECT_EQ(r.exit_code, 2) << message;
    EXPECT_THAT(r.err, HasSubstr(message));
    EXPECT_EQ(std::ranges::count(r.err, '\n'), 1) << r.err;
    EXPECT_EQ(r.out, "");
  }
  /// A folder of `count` grey pictures, each brighter than the one before.
  void make_pictures(int count) {
    std::filesystem::create_directory(file("pictures"));
    for (int i = 0; i < count; ++i) {
      camera::Frame frame = camera::make_frame(8, 6, camera::PixelFormat::Rgb24);
      std::ranges::fill(frame.bytes, static_cast<std::uint8_t>(10 * i));
      camera::write_png(frame, file("pictures/" + std::to_string(i) + ".png"));
    }
  }
  [[nodiscard]] std::string file(const std::string& name) const {
    return folder_.path() + "/" + name;
  }
  RunningProgram record(const std::string& out) {
    return RunningProgram({{EYEBRIDGE_BIN "/eyebridge", "camera", "record", "--camera", "pattern",
                            "--size", "32x24", "--out", out},
                           {},
                           folder_.path()});
  }

  ScratchFolder folder_;
};

TEST_F(CameraCommand, ShowTellsSizeRateAndBrightnessAndWritesAPicture) {
  const ProgramRun r = camera(
      {"show", "--camera", "pattern", "--frames", "5", "--size", "160x120", "--out", "p.png"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, AllOf(ContainsRegex("camera +pattern\n"), ContainsRegex("size +160 x 120"),
                           ContainsRegex("frames +5 in 0\\.[0-9]+ s: [0-9.]+ a second"),
                           ContainsRegex("brightness +1[0-9][0-9] of 255"),
                           ContainsRegex("picture +p.png\n")));
  EXPECT_THAT(r.out, ::testing::Not(HasSubstr("\x1b"))) << "no terminal, no colours";
  EXPECT_EQ(camera::read_png(file("p.png")).width, 160);
}

TEST_F(CameraCommand, WhatIsRecordedIsShownAndIsACamera) {
  make_pictures(4);
  const ProgramRun made =
      camera({"record", "--camera", "frames:pictures?pick=each", "--out", "a.ebrec"});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("a.ebrec: 4 frames in 0."));
  EXPECT_FALSE(std::filesystem::exists(file("a.ebrec-wal")));
  camera::FrameReader frames(file("a.ebrec"));
  ASSERT_EQ(frames.frames().size(), 4U);
  EXPECT_EQ(frames.read(3).value().bytes[0], 30);
  const ProgramRun told = run_command({"record", "--show", "a.ebrec"}, folder_.path());
  EXPECT_THAT(told.out, ContainsRegex("frames +4, 8 x 6 pixels, lossless, 0.0 MB, "));
  const ProgramRun shown = camera({"show", "--camera", "frames:a.ebrec?pick=each"});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_THAT(shown.out, AllOf(ContainsRegex("frames +4 in "), ContainsRegex("brightness +30 of")));
}

TEST_F(CameraCommand, RecordEndsAfterItsTimeAndTakesMjpeg) {
  const ProgramRun r = camera({"record", "--camera", "pattern", "--out", "a.ebrec", "--seconds",
                               "0.2", "--codec", "mjpeg", "--size", "64x48"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  const camera::FrameReader frames(file("a.ebrec"));
  ASSERT_GE(frames.frames().size(), 2U);
  EXPECT_EQ(frames.frames()[0].codec, camera::FrameCodec::Mjpeg);
  EXPECT_EQ(frames.frames()[0].size, (camera::Size{64, 48}));
  EXPECT_GE(frames.frames().back().given - frames.frames().front().given,
            std::chrono::milliseconds(200));
}

TEST_F(CameraCommand, CtrlCEndsARecordingCleanly) {
  RunningProgram program = record("a.ebrec");
  program.wait_for("recording, Ctrl-C ends");
  EXPECT_EQ(program.finish(SIGINT), 0);
  EXPECT_THAT(program.said(), ContainsRegex("a.ebrec: [0-9]+ frames in"));
  EXPECT_FALSE(std::filesystem::exists(file("a.ebrec-wal")));
  EXPECT_FALSE(camera::FrameReader(file("a.ebrec")).frames().empty());
}

TEST_F(CameraCommand, ARecordingThatIsKilledHasAllButItsLastSecond) {
  RunningProgram program = record("a.ebrec");
  const std::string said = program.wait_for(" frames in 2.");
  EXPECT_EQ(program.finish(SIGKILL), 128 + SIGKILL);
  camera::FrameReader frames(file("a.ebrec"));
  ASSERT_FALSE(frames.frames().empty());
  const Time span = frames.frames().back().given - frames.frames().front().given;
  EXPECT_GE(span, std::chrono::milliseconds(1000)) << "two were recorded";
  EXPECT_TRUE(frames.read(frames.frames().size() - 1));
}

TEST_F(CameraCommand, ADamagedPictureIsNamedAndTheRestIsRecorded) {
  make_pictures(3);
  std::filesystem::resize_file(file("pictures/1.png"), 60);
  const ProgramRun r =
      camera({"record", "--camera", "frames:pictures?pick=each", "--out", "a.ebrec"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.err, HasSubstr("warning: camera: pictures/1.png: cannot read picture"));
  EXPECT_THAT(r.out, HasSubstr("2 frames in"));
  EXPECT_THAT(r.out, HasSubstr("1 damaged"));
}

TEST_F(CameraCommand, ShowCountsWhatIsOddInJpegs) {
  std::filesystem::create_directories(file("odd"));
  const std::string from = EYEBRIDGE_SHARED_DIR "/cases/pictures/noeoi.jpg";
  for (const char* name : {"odd/1.jpg", "odd/2.jpg"}) std::filesystem::copy_file(from, file(name));
  const ProgramRun r = camera({"show", "--camera", "frames:odd?pick=each&rotate=90"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, ContainsRegex("frames +2 .*, 2 odd\n"));
  EXPECT_THAT(r.out, ContainsRegex("odd +2 JPEGs without an end: all their rows are there\n"));
}

TEST_F(CameraCommand, ACameraWithoutFramesFails) {
  make_pictures(1);
  std::filesystem::resize_file(file("pictures/0.png"), 60);
  const ProgramRun r = camera({"show", "--camera", "frames:pictures"});
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_THAT(r.err, HasSubstr("no frame came"));
}

TEST_F(CameraCommand, BadInputIsOneClearMessage) {
  expect_bad_input({"show", "--camera", "render"}, "--camera: found render, which needs a robot");
  expect_bad_input({"show", "--camera", "webcam:3"}, "\"webcam:3\" is not known, expected one of");
  expect_bad_input({"show", "--camera", "frames:none"}, "found nothing at none");
  expect_bad_input({"show", "--camera", "pattern", "--size", "640"}, "--size: found '640'");
  expect_bad_input({"show", "--camera", "pattern", "--size", "9000x10"}, "--size: camera: a frame");
  expect_bad_input({"record", "--camera", "pattern", "--out", "/no/such/a.ebrec"},
                   "--out: cannot write /no/such/a.ebrec");
  EXPECT_EQ(camera({"record", "--camera", "pattern"}).exit_code, 2);
  EXPECT_EQ(camera({"show"}).exit_code, 2);
  { const camera::RecordingFile empty(file("empty.ebrec"), {}); }
  expect_bad_input({"show", "--camera", "frames:empty.ebrec"}, "found a recording without frames");
  make_pictures(1);
  camera({"record", "--camera", "frames:pictures", "--out", "a.ebrec"});
  expect_bad_input({"record", "--camera", "frames:a.ebrec?end=loop", "--out", "./a.ebrec"},
                   "--out: found ./a.ebrec, which --camera reads; expected another file");
}

}  // namespace
}  // namespace eyebridge
