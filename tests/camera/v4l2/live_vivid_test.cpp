// A camera of the kernel's own (vivid, an HDMI input: any size at 60 frames a second), with its
// faults. Needs /dev/video0 to be one: the lab runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "all_log.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/bridges/monotonic_clock.hpp"
#include "eyebridge/camera/devices.hpp"
#include "eyebridge/camera/source.hpp"
#include "patience.hpp"
#include "v4l2/controls.hpp"
#include "v4l2/v4l2_source.hpp"
#include "v4l2/video_handle.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

const std::string kDevice = "/dev/video0";

class Vivid : public ::testing::Test {
 protected:
  ~Vivid() override {
    source_.reset();
    set("percentage_of_dropped_buffers", "0");
  }

  void open(const std::string& options = "?size=320x240") {
    source_.reset();  // the camera is for one at a time
    source_ =
        std::make_unique<V4l2Source>(system_video_calls(), parse_camera_url(kDevice + options),
                                     SourceContext{&clock_, nullptr, &log_});
  }
  /// Sets a control from outside, as v4l2-ctl would.
  static void set(const std::string& control, const std::string& value = "1") {
    const VideoHandle other(system_video_calls(), kDevice);
    ASSERT_EQ(other.error(), 0);
    set_controls(other, {{control, value}});
  }
  Result<FramePtr> next() { return source_->next(clock_.now() + kPatience); }
  std::string error_of(const std::string& options) {
    try {
      open(options);
    } catch (const ConfigError& error) {
      return error.text();
    }
    return "";
  }

  bridges::MonotonicClock clock_;
  AllLog log_;
  std::unique_ptr<V4l2Source> source_;
};

TEST_F(Vivid, EachFormatAndSizeIsGivenAtFullRate) {
  for (const char* name : {"YUYV", "NV12", "RGB24", "GREY"}) {
    for (const Size size : {Size{160, 120}, Size{320, 240}, Size{640, 480}}) {
      open("?size=" + to_text(size) + "&format=" + name);
      ASSERT_TRUE(next());
      const Time start = clock_.now();
      for (std::uint64_t i = 1; i <= 30; ++i) {
        const Result<FramePtr> frame = next();
        ASSERT_TRUE(frame) << name << ": " << frame.error().what;
        EXPECT_EQ((*frame)->sequence, i);
        EXPECT_EQ((Size{(*frame)->width, (*frame)->height}), size);
      }
      EXPECT_NEAR(to_seconds(clock_.now() - start), 0.5, 0.04) << name << " " << size.width;
    }
  }
}

TEST_F(Vivid, AllFormatsShowTheSamePicture) {
  set("test_pattern", "5");  // black
  const auto first_pixel = [&](const char* format) {
    open(std::string("?size=320x240&format=") + format);
    const Result<FramePtr> frame = next();
    EXPECT_TRUE(frame);
    // Below the text of the driver.
    return frame ? int{(*frame)->row(200)[600]} : -1;
  };
  for (const char* format : {"YUYV", "NV12", "RGB24", "GREY"}) EXPECT_LE(first_pixel(format), 16);
  set("test_pattern", "6");  // white
  for (const char* format : {"YUYV", "NV12", "RGB24", "GREY"}) EXPECT_GE(first_pixel(format), 235);
  set("test_pattern", "0");
}

TEST_F(Vivid, ControlsAreSetByName) {
  open("?size=320x240&test_pattern=100_black&osd_text_mode=none");
  const Result<FramePtr> black = next();
  ASSERT_TRUE(black);
  EXPECT_LE(*std::ranges::max_element((*black)->bytes), 16);
  EXPECT_THAT(error_of("?brightness=256"), HasSubstr("whole number from 0 to 255"));
  EXPECT_THAT(error_of("?bright=1"), AllOf(HasSubstr("'bright'"), HasSubstr("saturation")));
  set("osd_text_mode", "0");
  set("test_pattern", "0");
}

TEST_F(Vivid, AnotherReaderIsBusy) {
  open();
  ASSERT_TRUE(next());
  std::string text;
  try {
    V4l2Source second(system_video_calls(), parse_camera_url(kDevice), {&clock_, nullptr, &log_});
  } catch (const ConfigError& error) {
    text = error.text();
  }
  EXPECT_THAT(text, HasSubstr("in use by another program"));
  EXPECT_TRUE(next());
}

TEST_F(Vivid, DroppedFramesAreGapsAndAreCounted) {
  set("percentage_of_dropped_buffers", "30");
  open();
  std::uint64_t last = 0;
  for (int i = 0; i < 100; ++i) {
    const Result<FramePtr> frame = next();
    ASSERT_TRUE(frame);
    last = (*frame)->sequence;
  }
  EXPECT_GT(last, 110U);
  EXPECT_EQ(source_->counts().dropped + source_->counts().given, last + 1);
}

TEST_F(Vivid, AFrameThatTheDriverMarksIsCorrupt) {
  open();
  ASSERT_TRUE(next());
  set("inject_v4l2_buf_flag_error");
  int corrupt = 0;
  for (int i = 0; i < 10; ++i) {
    const Result<FramePtr> frame = next();
    if (!frame) corrupt += frame.error().code == Errc::Corrupt ? 1 : 100;
  }
  EXPECT_EQ(corrupt, 1);
  EXPECT_EQ(source_->counts().corrupt, 1U);
}

TEST_F(Vivid, AFatalErrorStartsStreamingAgain) {
  open();
  ASSERT_TRUE(next());
  set("inject_fatal_streaming_error");
  const Result<FramePtr> frame = next();
  ASSERT_TRUE(frame) << frame.error().what;
  EXPECT_GE((*frame)->sequence, 2U);
  EXPECT_EQ(source_->counts().restarts, 1U);
  EXPECT_THAT(log_.warnings, ElementsAre(HasSubstr("streaming is started again"),
                                         HasSubstr("sends frames again")));
}

TEST_F(Vivid, ErrorsAtTheStartAreConfigErrors) {
  open();
  source_.reset();
  set("inject_vidioc_streamon_error");
  EXPECT_THAT(error_of("?size=320x240"), HasSubstr("starting to stream failed"));
  EXPECT_EQ(error_of("?size=320x240"), "");
  source_.reset();
  set("inject_vidioc_reqbufs_error");
  EXPECT_THAT(error_of("?size=320x240"), HasSubstr("asking for buffers failed"));
}

TEST_F(Vivid, UnpluggingIsOneLossAndItComesBack) {
  open();
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(next());
    set("disconnect");
    const Time gone = clock_.now();
    const Result<FramePtr> lost = next();
    ASSERT_FALSE(lost);
    EXPECT_EQ(lost.error().code, Errc::Disconnected);
    const Result<FramePtr> back = next();
    ASSERT_TRUE(back) << back.error().what;
    EXPECT_GE((*back)->time, gone);
  }
  EXPECT_EQ(source_->counts().losses, 3U);
  EXPECT_THAT(log_.warnings, SizeIs(6));
}

TEST_F(Vivid, IsListed) {
  const std::vector<CameraDevice> found = list_cameras();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].path, kDevice);
  EXPECT_EQ(found[0].card, "vivid");
  EXPECT_EQ(found[0].kind, DeviceKind::Camera);
  const auto yuyv = std::ranges::find(found[0].formats, "YUYV", &OfferedFormat::name);
  ASSERT_NE(yuyv, found[0].formats.end());
  EXPECT_TRUE(yuyv->is_read);
  EXPECT_TRUE(yuyv->sizes.at(0).is_range());
}

}  // namespace
}  // namespace eyebridge::camera::testing
