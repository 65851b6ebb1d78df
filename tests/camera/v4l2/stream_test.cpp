// What frames of a live camera promise, and what its faults look like to a program.
#include <cerrno>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rig.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr Time kFrame{33'333'333};
constexpr Time kLong = std::chrono::seconds(2);
constexpr const char* kLink = "usb-Maker_Webcam-video-index0";

/// A camera whose grey frames are full of the driver's sequence number.
class LiveCamera : public ::testing::Test {
 protected:
  LiveCamera() : camera_(rig_.video.add("video0")) {
    camera_.formats = {{V4L2_PIX_FMT_GREY, {{320, 240}}, {30.0}}};
    rig_.video.link(kLink, "video0");
    source_ = rig_.open("video0");
  }

  Result<FramePtr> next(Time patience = kLong) {
    return source_->next(rig_.video.now() + patience);
  }
  FramePtr frame() {
    const Result<FramePtr> got = next();
    EXPECT_TRUE(got) << got.error().what;
    return got ? *got : nullptr;
  }
  Error error(Time patience = kLong) {
    const Result<FramePtr> got = next(patience);
    EXPECT_FALSE(got);
    return got ? Error{} : got.error();
  }

  Rig rig_;
  FakeCamera& camera_;
  std::unique_ptr<V4l2Source> source_;
};

TEST_F(LiveCamera, FramesComeOnceInOrderWithTheTimeTheyWereTaken) {
  const Time start = rig_.video.now();
  for (std::uint64_t i = 0; i < 40; ++i) {
    const FramePtr got = frame();
    ASSERT_NE(got, nullptr);
    EXPECT_EQ(got->sequence, i);
    EXPECT_EQ(got->bytes[0], i);
    EXPECT_NEAR(to_seconds(got->time - start), static_cast<double>(i + 1) / 30.0, 2e-6);
    EXPECT_LE(got->time, rig_.video.now());
  }
  EXPECT_EQ(source_->counts().given, 40U);
  EXPECT_EQ(source_->counts().dropped, 0U);
}

TEST_F(LiveCamera, ASlowProgramGetsTheNewestAndSeesTheGap) {
  EXPECT_EQ(frame()->sequence, 0U);
  rig_.video.pass(3 * kFrame + Time(1000));
  EXPECT_EQ(frame()->sequence, 3U);
  EXPECT_EQ(frame()->sequence, 4U);
  EXPECT_EQ(source_->counts().dropped, 2U);
}

TEST_F(LiveCamera, AfterALongPauseNothingThatWaitedInTheBuffersIsGiven) {
  EXPECT_EQ(frame()->sequence, 0U);
  rig_.video.pass(std::chrono::seconds(5));  // the driver fills its buffers and drops the rest
  const Time asked = rig_.video.now();
  const FramePtr got = frame();
  EXPECT_GE(got->time, asked);
  EXPECT_EQ(got->bytes[0], 151);
  EXPECT_EQ(got->sequence, 151U);
  EXPECT_EQ(source_->counts().dropped, 150U);
}

TEST_F(LiveCamera, ADriverThatStampsNothingGivesNoOldFrameEither) {
  camera_.counts = false;
  EXPECT_EQ(frame()->sequence, 0U);
  rig_.video.pass(std::chrono::seconds(5));
  const Time asked = rig_.video.now();
  EXPECT_EQ(frame()->bytes[0], 151);
  EXPECT_GE(rig_.video.now(), asked);
  EXPECT_EQ(frame()->sequence, 2U);
}

TEST_F(LiveCamera, AFrameAfterTheDeadlineIsATimeoutAtTheDeadlineAndIsNotLost) {
  ASSERT_NE(frame(), nullptr);
  const Time deadline = rig_.video.now() + Time(30'000'000);
  const Error late = error(Time(30'000'000));
  EXPECT_EQ(late.code, Errc::Timeout);
  EXPECT_EQ(rig_.video.now(), deadline);
  EXPECT_EQ(frame()->sequence, 1U);
}

TEST_F(LiveCamera, ADeadlineOfNowGivesAFrameOnlyWhenOneIsThere) {
  EXPECT_FALSE(next(Time(0)));
  rig_.video.pass(kFrame + Time(10));
  EXPECT_TRUE(next(Time(0)));
  EXPECT_FALSE(next(Time(0)));
}

TEST_F(LiveCamera, SizeCanChangeBetweenFrames) {
  EXPECT_EQ(source_->natural_size(), (Size{320, 240}));
  for (const auto& [width, height] : {std::pair{160, 120}, {640, 480}, {320, 240}, {33, 17}}) {
    ASSERT_TRUE(source_->set_size(width, height));
    const FramePtr got = frame();
    EXPECT_EQ(got->width, width);
    EXPECT_EQ(got->height, height);
    EXPECT_EQ(got->format, PixelFormat::Rgb24);
  }
  for (const auto& [width, height] : {std::pair{0, 120}, {160, -1}, {5000, 120}}) {
    const Result<void> result = source_->set_size(width, height);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, Errc::OutOfRange);
  }
  EXPECT_EQ(frame()->width, 33);
}

TEST_F(LiveCamera, AFrameOutlivesItsSource) {
  const FramePtr got = frame();
  const std::vector<std::uint8_t> bytes = got->bytes;
  ASSERT_NE(frame(), nullptr);
  source_.reset();
  EXPECT_EQ(got->bytes, bytes);
  EXPECT_EQ(rig_.video.open_devices(), 0);
  EXPECT_EQ(rig_.video.mappings(), 0);
}

TEST_F(LiveCamera, DamagedFramesAreSaidAndTheNextOneGoesOn) {
  camera_.marks_damaged = true;
  EXPECT_EQ(error().code, Errc::Corrupt);
  camera_.marks_damaged = false;
  camera_.picture = [](std::uint32_t) { return Bytes(100); };
  const Error cut = error();
  EXPECT_EQ(cut.code, Errc::Corrupt);
  EXPECT_THAT(cut.what, HasSubstr("100 bytes, expected 76800"));
  camera_.picture = nullptr;
  EXPECT_EQ(frame()->sequence, 2U);
  EXPECT_EQ(source_->counts().corrupt, 2U);
}

TEST_F(LiveCamera, ACameraThatFallsSilentIsStartedAgain) {
  ASSERT_NE(frame(), nullptr);
  camera_.restarts_to_speak = camera_.starts;  // speaks when started once more
  const FramePtr got = frame();
  ASSERT_NE(got, nullptr);
  EXPECT_GT(got->sequence, 1U) << "frames were lost";
  EXPECT_EQ(source_->counts().restarts, 1U);
  EXPECT_THAT(rig_.log.warnings, ElementsAre(HasSubstr("no frame for 1 s; streaming is started"),
                                             HasSubstr("sends frames again")));
}

TEST_F(LiveCamera, OneThatStaysSilentIsATimeoutWithTheReason) {
  camera_.is_silent = true;
  const Error silent = error();
  EXPECT_EQ(silent.code, Errc::Timeout);
  EXPECT_THAT(silent.what, HasSubstr("(no frame for 1 s)"));
  EXPECT_EQ(error().code, Errc::Timeout);
  EXPECT_GE(source_->counts().restarts, 3U);
  EXPECT_THAT(rig_.log.warnings, SizeIs(1));
  camera_.is_silent = false;
  EXPECT_NE(frame(), nullptr);
}

TEST_F(LiveCamera, AnErrorOfTheDriverStartsStreamingAgain) {
  ASSERT_NE(frame(), nullptr);
  camera_.fails[VIDIOC_DQBUF] = EIO;
  EXPECT_EQ(error(Time(250'000'000)).code, Errc::Timeout);
  EXPECT_EQ(source_->counts().restarts, 3U) << "not more than ten a second";
  EXPECT_THAT(rig_.log.warnings, SizeIs(1));
  camera_.fails.clear();
  EXPECT_NE(frame(), nullptr);
  EXPECT_THAT(rig_.log.warnings, SizeIs(2));
}

TEST_F(LiveCamera, UnpluggingIsSaidOnceAndTheCameraIsTakenUpAgain) {
  ASSERT_NE(frame(), nullptr);
  camera_.is_gone = true;
  const Error gone = error();
  EXPECT_EQ(gone.code, Errc::Disconnected);
  EXPECT_THAT(gone.what, AllOf(HasSubstr(kLink), HasSubstr("unplugged")));
  EXPECT_EQ(rig_.video.open_devices(), 0);
  EXPECT_EQ(rig_.video.mappings(), 0);

  for (int i = 0; i < 5; ++i) {
    const Error still = error();
    EXPECT_EQ(still.code, Errc::Timeout);
    EXPECT_THAT(still.what, HasSubstr("unplugged, and not found again"));
  }
  EXPECT_THAT(rig_.log.warnings, SizeIs(1));

  camera_.is_gone = false;
  const Time back = rig_.video.now();
  const FramePtr got = frame();
  ASSERT_NE(got, nullptr);
  EXPECT_GE(got->time, back);
  EXPECT_EQ(got->sequence, 2U) << "a gap shows the loss";
  EXPECT_THAT(rig_.log.warnings, ElementsAre(HasSubstr("unplugged"), HasSubstr("is back")));
  EXPECT_EQ(source_->counts().losses, 1U);
}

TEST_F(LiveCamera, ItIsFoundByItsLastingNameUnderAnotherNumber) {
  ASSERT_NE(frame(), nullptr);
  camera_.is_gone = true;
  EXPECT_EQ(error().code, Errc::Disconnected);
  rig_.video.add("video4").formats = camera_.formats;
  rig_.video.unlink(kLink);
  rig_.video.link(kLink, "video4");
  EXPECT_NE(frame(), nullptr);
}

TEST_F(LiveCamera, AnotherCameraInItsPlaceIsNotTaken) {
  ASSERT_NE(frame(), nullptr);
  camera_.is_gone = true;
  EXPECT_EQ(error().code, Errc::Disconnected);
  camera_.is_gone = false;
  camera_.card = "Other";
  EXPECT_THAT(error().what, HasSubstr("another camera now (Other)"));
  camera_.card = "Webcam";
  EXPECT_NE(frame(), nullptr);
}

TEST_F(LiveCamera, WhatFailsOnReturnIsTriedAgain) {
  ASSERT_NE(frame(), nullptr);
  camera_.is_gone = true;
  EXPECT_EQ(error().code, Errc::Disconnected);
  camera_.is_gone = false;
  camera_.open_fails = EACCES;  // udev has not set the group yet
  EXPECT_THAT(error().what, HasSubstr("not permitted"));
  camera_.open_fails = 0;
  EXPECT_NE(frame(), nullptr);
}

TEST_F(LiveCamera, ALossWhileFramesWaitGivesNoneOfThem) {
  ASSERT_NE(frame(), nullptr);
  rig_.video.pass(2 * kFrame);
  camera_.is_gone = true;
  EXPECT_EQ(error().code, Errc::Disconnected);
}

}  // namespace
}  // namespace eyebridge::camera::testing
