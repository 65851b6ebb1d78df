// What is said about cameras, on machines that are made up.
#include "machine/cameras.hpp"

#include <cerrno>

#include <gmock/gmock.h>

#include "fake_machine.hpp"

namespace eyebridge::apps {
namespace {

using eyebridge::testing::FakeMachine;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;

Camera webcam() {
  Camera out;
  out.device = {"/dev/video2",
                "/dev/v4l/by-id/usb-Maker_C525-video-index0",
                "C525",
                "",
                camera::DeviceKind::Camera,
                0,
                {}};
  const auto size = [](int width, int height) {
    return camera::OfferedSize{{width, height}, {width, height}, {1, 1}, {30.0, 15.0}};
  };
  out.device.formats = {{1, "YUYV", true, {size(640, 480), size(320, 240)}},
                        {2, "H264", false, {size(640, 480)}}};
  out.access = {"video", true, true, true};
  return out;
}

TEST(Cameras, TheTableHasWhatOneNeedsForAUrl) {
  const std::string table = table_of({webcam()});
  EXPECT_EQ(table,
            "/dev/video2   C525\n"
            "    usb-Maker_C525-video-index0\n"
            "    YUYV    640x480, 320x240 at 30, 15 /s\n"
            "    also    H264 (not used)\n"
            "A program with the first:  eyebridge run --camera v4l2:usb-Maker_C525-video-index0 "
            "PROGRAM\n");
}

TEST(Cameras, SizesWithOtherRatesAndRangesHaveLinesOfTheirOwn) {
  Camera camera = webcam();
  camera.device.formats[0].sizes[1].rates = {60.0};
  camera.device.formats[1] = {3, "GREY", true, {{{16, 16}, {640, 480}, {2, 4}, {}}}};
  EXPECT_THAT(table_of({camera}),
              AllOf(HasSubstr("    YUYV    640x480 at 30, 15 /s\n            320x240 at 60 /s\n"),
                    HasSubstr("    GREY    16x16 to 640x480 in steps of 2x4\n")));
}

TEST(Cameras, WhoMayNotUseOneIsToldWhatToDo) {
  Camera camera = webcam();
  camera.device.error = EACCES;
  camera.access.permitted = camera.access.in_group = false;
  EXPECT_THAT(table_of({camera}), HasSubstr("sudo usermod -aG video $USER"));
  const auto findings = judge_cameras({camera});
  ASSERT_THAT(findings, SizeIs(2));
  EXPECT_FALSE(findings[1].found);
  EXPECT_THAT(findings[1].remedy, HasSubstr("join the group video"));
  camera.access.in_group = true;
  EXPECT_THAT(judge_cameras({camera})[1].remedy, HasSubstr("log out and in again"));
  camera.access.group_may = false;
  EXPECT_THAT(judge_cameras({camera})[1].remedy, HasSubstr("only root"));
}

TEST(Cameras, OneThatFailsToOpenSaysWhy) {
  Camera camera = webcam();
  camera.device.error = EIO;
  EXPECT_THAT(table_of({camera}), HasSubstr("cannot be opened: Input/output error (errno 5)"));
}

TEST(Cameras, MetadataNodesAreNoCameras) {
  Camera metadata = webcam();
  metadata.device.kind = camera::DeviceKind::Metadata;
  metadata.device.formats.clear();
  EXPECT_THAT(table_of({metadata}), AllOf(HasSubstr("C525: metadata of a camera, no pictures"),
                                          HasSubstr("None of these is a camera")));
  const auto findings = judge_cameras({metadata});
  EXPECT_FALSE(findings[0].found);
  EXPECT_FALSE(findings[1].found);
}

TEST(Cameras, WithoutAnyThatIsSaid) {
  EXPECT_EQ(table_of({}), "Found no camera (no /dev/video*).\n");
  EXPECT_THAT(judge_cameras({}), SizeIs(1));
}

TEST(Cameras, AMachineIsReadWithoutItsKernel) {
  const FakeMachine machine;
  machine.add_video(10, "Webcam C525", ":capture:", "usb-Maker_C525-video-index0");
  machine.add_video(2, "Webcam C525", ":");
  machine.add_process(900, "cheese", "/dev/video10");
  const std::vector<Camera> cameras = look_at_cameras(machine.root());
  ASSERT_THAT(cameras, SizeIs(2));
  EXPECT_EQ(cameras[0].device.path, "/dev/video2");
  EXPECT_EQ(cameras[0].device.kind, camera::DeviceKind::Metadata);
  EXPECT_EQ(cameras[1].device.kind, camera::DeviceKind::Camera);
  EXPECT_EQ(cameras[1].device.card, "Webcam C525");
  EXPECT_THAT(table_of(cameras), HasSubstr("in use by cheese (process 900)"));
}

}  // namespace
}  // namespace eyebridge::apps
