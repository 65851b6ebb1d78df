// Opening live cameras: what is chosen, and one clear error for each way to fail.
#include <cerrno>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/jumping_clock.hpp"
#include "rig.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

FakeFormat format(std::uint32_t fourcc, std::vector<std::pair<int, int>> sizes = {{640, 480}},
                  std::vector<double> rates = {30.0}) {
  return {fourcc, std::move(sizes), std::move(rates)};
}

TEST(LiveCameraOpen, TheFirstThatGivesPicturesIsTakenWhenNoneIsNamed) {
  Rig rig;
  rig.video.add("video0").can = V4L2_CAP_META_CAPTURE | V4L2_CAP_STREAMING;
  rig.video.add("video10").card = "Tenth";
  rig.video.add("video2").card = "Second";
  const auto source = rig.open("");
  EXPECT_THAT(rig.log.others, ElementsAre(HasSubstr("/dev/video2: 640x480 YUYV, 30 frames")));
}

TEST(LiveCameraOpen, ACameraIsFoundByItsLastingName) {
  Rig rig;
  rig.video.add("video3");
  rig.video.link("usb-Maker_Webcam-video-index0", "video3");
  for (const char* name : {"usb-Maker_Webcam-video-index0", "video3", "/dev/video3",
                           "/dev/v4l/by-id/usb-Maker_Webcam-video-index0"}) {
    EXPECT_EQ(rig.error_of(name), "") << name;
  }
  EXPECT_THAT(rig.log.others, ::testing::Each(HasSubstr("usb-Maker_Webcam-video-index0")));
}

TEST(LiveCameraOpen, ANameThatIsNotThereIsAnErrorThatNamesThoseThatAre) {
  Rig rig;
  rig.video.add("video3");
  rig.video.link("usb-Maker_Webcam-video-index0", "video3");
  EXPECT_THAT(rig.error_of("usb-Other"),
              AllOf(HasSubstr("usb-Other"), HasSubstr("usb-Maker_Webcam-video-index0")));
  EXPECT_THAT(rig.error_of("/dev/video9"),
              AllOf(HasSubstr("/dev/video9: there is no such camera"), HasSubstr("camera list")));
}

TEST(LiveCameraOpen, NoCameraAtAllIsSaid) {
  Rig rig;
  EXPECT_THAT(rig.error_of(""), HasSubstr("no camera (no /dev/video*)"));
  rig.video.add("video0").can = V4L2_CAP_VIDEO_OUTPUT;
  EXPECT_THAT(rig.error_of(""), HasSubstr("give no pictures: /dev/video0"));
}

TEST(LiveCameraOpen, AMetadataNodeNamesItsCamera) {
  Rig rig;
  rig.video.add("video0");
  rig.video.add("video4");
  rig.video.add("video5").can = V4L2_CAP_META_CAPTURE | V4L2_CAP_STREAMING;
  rig.video.add_sys("video0", "usb1/1-1");
  rig.video.add_sys("video4", "usb1/1-2");
  rig.video.add_sys("video5", "usb1/1-2");
  EXPECT_THAT(rig.error_of("/dev/video5"),
              AllOf(HasSubstr("metadata"), HasSubstr("its camera is /dev/video4")));
}

TEST(LiveCameraOpen, ADeviceOfAnotherKindIsRefused) {
  Rig rig;
  rig.video.add("video0").fails[VIDIOC_QUERYCAP] = ENOTTY;
  EXPECT_THAT(rig.error_of("video0"), HasSubstr("no V4L2 device"));
  rig.video.add("video1").can = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_READWRITE;
  EXPECT_THAT(rig.error_of("video1"), HasSubstr("does not stream"));
}

TEST(LiveCameraOpen, BusyIsSaidWhereverItShows) {
  for (const unsigned long request :
       {static_cast<unsigned long>(VIDIOC_S_FMT), static_cast<unsigned long>(VIDIOC_REQBUFS),
        static_cast<unsigned long>(VIDIOC_STREAMON)}) {
    Rig rig;
    rig.video.add("video0").fails[request] = EBUSY;
    EXPECT_THAT(rig.error_of("video0"), HasSubstr("in use by another program"));
    EXPECT_EQ(rig.video.open_devices(), 0);
    EXPECT_EQ(rig.video.mappings(), 0);
  }
  Rig rig;
  rig.video.add("video0").open_fails = EBUSY;
  EXPECT_THAT(rig.error_of("video0"), HasSubstr("in use by another program"));
}

TEST(LiveCameraOpen, WithoutPermissionTheGroupIsNamed) {
  Rig rig;
  rig.video.add("video0").open_fails = EACCES;
  const std::string node = rig.video.root() + "/dev/video0";
  ASSERT_EQ(::system(("chmod 660 " + node).c_str()), 0);
  EXPECT_THAT(rig.error_of("video0"),
              AllOf(HasSubstr("not permitted"), HasSubstr("the group "), HasSubstr("usermod -aG")));
  EXPECT_THAT(rig.error_of(""), HasSubstr("not permitted"));
  ASSERT_EQ(::system(("chmod 600 " + node).c_str()), 0);
  EXPECT_THAT(rig.error_of("video0"), Not(HasSubstr("usermod")));
}

TEST(LiveCameraOpen, OtherErrorsTellTheirErrno) {
  Rig rig;
  rig.video.add("video0").open_fails = EIO;
  EXPECT_THAT(rig.error_of("video0"), HasSubstr("(errno 5)"));
  rig.video.add("video1").fails[VIDIOC_STREAMON] = ENOSPC;  // no USB bandwidth left
  EXPECT_THAT(rig.error_of("video1"),
              AllOf(HasSubstr("starting to stream"), HasSubstr("bandwidth")));
}

TEST(LiveCameraOpen, ASizeThatIsNotOfferedNamesTheNearest) {
  Rig rig;
  rig.video.add("video0").formats = {
      format(V4L2_PIX_FMT_YUYV, {{640, 480}, {352, 288}, {320, 240}, {160, 120}, {1280, 720}})};
  EXPECT_THAT(rig.error_of("video0?size=320x200"),
              AllOf(HasSubstr("320x200"), HasSubstr("nearest are 320x240, 352x288, 160x120")));
}

TEST(LiveCameraOpen, ARateThatIsNotOfferedNamesThoseThatAre) {
  Rig rig;
  rig.video.add("video0");
  EXPECT_THAT(rig.error_of("video0?fps=60"),
              AllOf(HasSubstr("60 frames a second"), HasSubstr("only 30 and 15")));
  EXPECT_EQ(rig.error_of("video0?fps=15"), "");
  EXPECT_EQ(rig.error_of("video0?fps=29.97"), "");
}

TEST(LiveCameraOpen, AFormatThatIsNotOfferedNamesThoseThatAre) {
  Rig rig;
  rig.video.add("video0").formats = {format(V4L2_PIX_FMT_YUYV), format(V4L2_PIX_FMT_H264)};
  EXPECT_THAT(rig.error_of("video0?format=MJPEG"),
              AllOf(HasSubstr("does not offer MJPEG"), HasSubstr("YUYV and H264")));
}

TEST(LiveCameraOpen, TheFirstFormatThatIsFastEnoughIsTaken) {
  Rig rig;
  rig.video.add("video0").formats = {format(V4L2_PIX_FMT_MJPEG, {{640, 480}}, {30.0}),
                                     format(V4L2_PIX_FMT_YUYV, {{640, 480}}, {10.0})};
  EXPECT_EQ(rig.open("video0")->mode().format, RawFormat::Mjpeg);
  EXPECT_EQ(rig.open("video0?fps=10")->mode().format, RawFormat::Yuyv);
  EXPECT_EQ(rig.open("video0?format=YUYV")->mode().fps, 10.0);
}

TEST(LiveCameraOpen, WithoutASizeTheNearestTo640x480IsTaken) {
  Rig rig;
  rig.video.add("video0").formats = {format(V4L2_PIX_FMT_YUYV, {{1920, 1080}, {800, 600}})};
  EXPECT_EQ(rig.open("video0")->natural_size(), (Size{800, 600}));
}

TEST(LiveCameraOpen, WhatNoneOfOursReadsIsConvertedByLibv4l) {
  Rig rig;
  FakeCamera& camera = rig.video.add("video0");
  camera.formats = {format(V4L2_PIX_FMT_SGRBG8)};
  camera.converted = {format(V4L2_PIX_FMT_SGRBG8), format(V4L2_PIX_FMT_RGB24)};
  const auto source = rig.open("video0");
  EXPECT_EQ(source->mode().format, RawFormat::Rgb24);
  ASSERT_FALSE(rig.log.others.empty());
  EXPECT_THAT(rig.log.others[0], AllOf(HasSubstr("GRBG"), HasSubstr("libv4l makes RGB24")));
  EXPECT_EQ(rig.video.open_devices(), 1);
}

TEST(LiveCameraOpen, AFormatThatNobodyReadsIsAnErrorThatNamesIt) {
  Rig rig;
  rig.video.add("video0").formats = {format(V4L2_PIX_FMT_H264), format(V4L2_PIX_FMT_VP9)};
  EXPECT_THAT(rig.error_of("video0"), AllOf(HasSubstr("H264 and VP90"), HasSubstr("expected one of "
                                                                                  "YUYV")));
}

TEST(LiveCameraOpen, SwitchesAreSetBeforeWhatTheySwitch) {
  Rig rig;
  FakeCamera& camera = rig.video.add("video0");
  camera.controls = {{"Exposure Time, Absolute", V4L2_CTRL_TYPE_INTEGER, 3, 2047},
                     {"Focus, Automatic Continuous", V4L2_CTRL_TYPE_BOOLEAN, 0, 1},
                     {"Auto Exposure",
                      V4L2_CTRL_TYPE_MENU,
                      0,
                      3,
                      0,
                      {"Auto Mode", "Manual Mode", "", "Aperture Priority Mode"}}};
  EXPECT_EQ(rig.error_of("video0?exposure_time_absolute=100&focus_automatic_continuous=off&"
                         "auto_exposure=manual_mode"),
            "");
  EXPECT_THAT(camera.set_controls, ElementsAre("Auto Exposure=1", "Focus, Automatic Continuous=0",
                                               "Exposure Time, Absolute=100"));
}

TEST(LiveCameraOpen, AnUnknownControlIsAnErrorThatNamesAll) {
  Rig rig;
  rig.video.add("video0").controls = {{"Brightness"}, {"White Balance, Automatic"}};
  EXPECT_THAT(rig.error_of("video0?brigtness=3"),
              AllOf(HasSubstr("'brigtness'"), HasSubstr("brightness, white_balance_automatic")));
}

TEST(LiveCameraOpen, AControlOutOfRangeIsAnErrorWithTheRange) {
  Rig rig;
  rig.video.add("video0").controls = {
      {"Brightness", V4L2_CTRL_TYPE_INTEGER, -64, 64},
      {"Power Line Frequency", V4L2_CTRL_TYPE_MENU, 0, 2, 0, {"Disabled", "50 Hz", "60 Hz"}},
      {"Privacy", V4L2_CTRL_TYPE_BOOLEAN, 0, 1, V4L2_CTRL_FLAG_READ_ONLY}};
  EXPECT_EQ(rig.error_of("video0?brightness=-64&power_line_frequency=50_hz"), "");
  EXPECT_THAT(rig.error_of("video0?brightness=65"),
              HasSubstr("found brightness='65', expected a whole number from -64 to 64"));
  EXPECT_THAT(rig.error_of("video0?brightness=much"), HasSubstr("expected a whole number"));
  EXPECT_THAT(rig.error_of("video0?power_line_frequency=3"),
              HasSubstr("one of 0 (disabled), 1 (50_hz), 2 (60_hz)"));
  EXPECT_THAT(rig.error_of("video0?privacy=1"), HasSubstr("can only be read"));
}

TEST(LiveCameraOpen, AControlThatTheCameraKeepsToItselfIsCalledSo) {
  Rig rig;
  FakeCamera& camera = rig.video.add("video0");
  camera.controls = {{"Brightness"},
                     {"Gain", V4L2_CTRL_TYPE_INTEGER, 0, 255, V4L2_CTRL_FLAG_INACTIVE}};
  camera.fails[VIDIOC_S_EXT_CTRLS] = EACCES;
  EXPECT_THAT(rig.error_of("video0?gain=3"),
              HasSubstr("setting gain=3 (the camera controls it by itself now: switch that off)"));
  EXPECT_THAT(rig.error_of("video0?brightness=3"), HasSubstr("setting brightness=3 failed: "));
}

TEST(LiveCameraUrl, BadOptionsAreRefusedWithoutOpeningAnything) {
  const auto error_of = [](const std::string& url) -> std::string {
    try {
      check_source(url, {nullptr, nullptr, nullptr});
    } catch (const ConfigError& error) {
      return error.text();
    }
    return "";
  };
  EXPECT_EQ(error_of("v4l2:/dev/video0?size=640x480&fps=29.97&format=YUYV&gain=3"), "");
  EXPECT_THAT(error_of("v4l2:?size=640"), HasSubstr("found size='640', expected WIDTHxHEIGHT"));
  EXPECT_THAT(error_of("v4l2:?size=0x480"), HasSubstr("1 ... 4096"));
  EXPECT_THAT(error_of("v4l2:?fps=0"), HasSubstr("more than 0"));
  EXPECT_THAT(error_of("v4l2:?fps=nan"), HasSubstr("more than 0"));
  EXPECT_THAT(error_of("v4l2:?format=yuv"), HasSubstr("one of YUYV, NV12, RGB24, MJPEG, GREY"));
  EXPECT_THAT(error_of("v4l2:?size=3x3&size=4x4"), HasSubstr("twice"));
}

TEST(LiveCameraUrl, VirtualTimeIsRefusedAtTheStart) {
  JumpingClock clock;
  EXPECT_THROW(check_source("v4l2:", {&clock, nullptr, nullptr}), ConfigError);
}

TEST(LiveCameraList, TellsNodesByNumberWithFormatsAndNames) {
  FakeVideo video;
  video.add("video10").can = V4L2_CAP_META_CAPTURE;
  video.add("video2").formats = {format(V4L2_PIX_FMT_YUYV, {{640, 480}}, {15.0, 30.0})};
  video.add("video3").open_fails = EACCES;
  video.link("usb-A-index0", "video2");
  const std::vector<CameraDevice> found = list_cameras(video, video.root());
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].path, "/dev/video2");
  EXPECT_EQ(found[0].by_id, "/dev/v4l/by-id/usb-A-index0");
  EXPECT_EQ(found[0].card, "Webcam");
  ASSERT_EQ(found[0].formats.size(), 1U);
  EXPECT_EQ(found[0].formats[0].sizes.at(0),
            (OfferedSize{{640, 480}, {640, 480}, {1, 1}, {30.0, 15.0}}));
  EXPECT_EQ(found[1].error, EACCES);
  EXPECT_EQ(found[1].kind, DeviceKind::Unknown);
  EXPECT_EQ(found[2].kind, DeviceKind::Metadata);
  EXPECT_EQ(video.open_devices(), 0);
}

TEST(OfferedSizes, TheNearestOfARangeKeepsItsSteps) {
  const OfferedSize range{{32, 16}, {640, 480}, {16, 4}, {}};
  EXPECT_EQ(range.nearest({640, 480}), (Size{640, 480}));
  EXPECT_EQ(range.nearest({1000, 1000}), (Size{640, 480}));
  EXPECT_EQ(range.nearest({1, 1}), (Size{32, 16}));
  EXPECT_EQ(range.nearest({57, 21}), (Size{64, 20}));
  EXPECT_TRUE(range.has({48, 20}));
  EXPECT_FALSE(range.has({50, 20}));
}

}  // namespace
}  // namespace eyebridge::camera::testing
