// Frames written to v4l2loopback are those that a program gets. Needs the device that
// EYEBRIDGE_TEST_VIDEO names: the lab runs it.
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/random.hpp"
#include "eyebridge/bridges/monotonic_clock.hpp"
#include "eyebridge/camera/devices.hpp"
#include "eyebridge/camera/source.hpp"
#include "jpeg_pictures.hpp"
#include "loopback_writer.hpp"
#include "patience.hpp"
#include "reference_colours.hpp"

namespace eyebridge::camera::testing {
namespace {

using Bytes = std::vector<std::uint8_t>;
using ::testing::HasSubstr;

constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr int kFrames = 90;

std::string device() {
  const char* name = std::getenv("EYEBRIDGE_TEST_VIDEO");
  return name == nullptr ? "/dev/video0" : name;
}

Bytes noise(std::size_t size, int number) {
  Random random(static_cast<std::uint64_t>(number) + 1);
  Bytes out(size);
  for (std::uint8_t& byte : out) byte = static_cast<std::uint8_t>(random.uniform() * 256.0);
  return out;
}

/// One of the formats: what is sent, and what must arrive.
struct LoopbackCase {
  const char* name;
  std::uint32_t fourcc;
  Bytes (*raw)(int number);
  Bytes (*rgb)(const Bytes& raw, int number);
  double least_psnr;  ///< dB; 0: exact.
};
void PrintTo(const LoopbackCase& one, std::ostream* out) { *out << one.name; }

Bytes nv12_reference(const Bytes& raw, int) {
  Bytes out;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const std::uint8_t* colour = raw.data() + kWidth * kHeight + y / 2 * kWidth + x / 2 * 2;
      const Pixel pixel =
          reference_rgb(raw[static_cast<std::size_t>(kWidth * y + x)], colour[0], colour[1]);
      out.insert(out.end(), pixel.begin(), pixel.end());
    }
  }
  return out;
}

Bytes grey_reference(const Bytes& raw, int) {
  Bytes out;
  for (const std::uint8_t byte : raw) out.insert(out.end(), 3, byte);
  return out;
}

const LoopbackCase kCases[] = {
    {"Yuyv", V4L2_PIX_FMT_YUYV, [](int n) { return noise(kWidth * kHeight * 2, n); },
     [](const Bytes& raw, int) { return reference_of_yuyv(raw); }, 0.0},
    {"Nv12", V4L2_PIX_FMT_NV12, [](int n) { return noise(kWidth * kHeight * 3 / 2, n); },
     nv12_reference, 0.0},
    {"Rgb24", V4L2_PIX_FMT_RGB24, [](int n) { return noise(kWidth * kHeight * 3, n); },
     [](const Bytes& raw, int) { return raw; }, 0.0},
    {"Grey", V4L2_PIX_FMT_GREY, [](int n) { return noise(kWidth * kHeight, n); }, grey_reference,
     0.0},
    {"Mjpeg", V4L2_PIX_FMT_MJPEG,
     [](int n) { return jpeg_of(smooth_picture(kWidth, kHeight, n), kWidth, kHeight); },
     [](const Bytes&, int n) { return smooth_picture(kWidth, kHeight, n); }, 45.0},
};

class Loopback : public ::testing::TestWithParam<LoopbackCase> {
 protected:
  void start() {
    writer_.emplace(device(), GetParam().fourcc, kWidth, kHeight);
    source_ = open_source("v4l2:" + device() + "?size=320x240", {&clock_, nullptr, nullptr});
  }

  bridges::MonotonicClock clock_;
  std::optional<LoopbackWriter> writer_;
  std::unique_ptr<Source> source_;
};

// Drivers stamp in whole microseconds.
constexpr Time kStamp = std::chrono::microseconds(1);

TEST_P(Loopback, FramesArriveAsTheyWereWrittenAndInOrder) {
  start();
  double worst = 1e9;
  for (int i = 0; i < kFrames; ++i) {
    const Bytes raw = GetParam().raw(i);
    const Time before = clock_.now();
    writer_->write(raw);
    const Result<FramePtr> frame = source_->next(clock_.now() + kPatience);
    ASSERT_TRUE(frame) << i << ": " << frame.error().what;
    EXPECT_EQ((*frame)->sequence, static_cast<std::uint64_t>(i));
    EXPECT_GE((*frame)->time + kStamp, before);
    EXPECT_LE((*frame)->time, clock_.now());
    const Bytes expected = GetParam().rgb(raw, i);
    if (GetParam().least_psnr == 0.0) {
      ASSERT_TRUE((*frame)->bytes == expected) << "frame " << i;
    } else {
      worst = std::min(worst, psnr((*frame)->bytes, expected));
    }
    clock_.wait_until(before + std::chrono::milliseconds(33));  // the rhythm of a camera
  }
  if (GetParam().least_psnr > 0.0) RecordProperty("worst_psnr", std::to_string(worst));
  EXPECT_GE(worst, GetParam().least_psnr);
}

TEST_P(Loopback, NoFrameIsATimeoutAndTheNextIsNotLost) {
  start();
  const Time deadline = clock_.now() + std::chrono::milliseconds(100);
  const Result<FramePtr> none = source_->next(deadline);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, Errc::Timeout);
  EXPECT_GE(clock_.now(), deadline);
  writer_->write(GetParam().raw(7));
  EXPECT_TRUE(source_->next(clock_.now() + kPatience));
}

TEST_P(Loopback, WhatWasWrittenBeforeOpeningIsNotGiven) {
  writer_.emplace(device(), GetParam().fourcc, kWidth, kHeight);
  writer_->write(GetParam().raw(0));
  clock_.wait_until(clock_.now() + std::chrono::milliseconds(50));
  source_ = open_source("v4l2:" + device(), {&clock_, nullptr, nullptr});
  EXPECT_FALSE(source_->next(clock_.now() + std::chrono::milliseconds(50)));
  const Bytes raw = GetParam().raw(1);
  writer_->write(raw);
  const Result<FramePtr> frame = source_->next(clock_.now() + kPatience);
  ASSERT_TRUE(frame) << frame.error().what;
  EXPECT_GE(psnr((*frame)->bytes, GetParam().rgb(raw, 1)), 45.0);
}

INSTANTIATE_TEST_SUITE_P(Formats, Loopback, ::testing::ValuesIn(kCases),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(LoopbackMjpeg, ADamagedFrameIsCorruptAndTheNextOneGoesOn) {
  bridges::MonotonicClock clock;
  LoopbackWriter writer(device(), V4L2_PIX_FMT_MJPEG, kWidth, kHeight);
  const auto source = open_source("v4l2:" + device(), {&clock, nullptr, nullptr});
  const Bytes whole = jpeg_of(smooth_picture(kWidth, kHeight), kWidth, kHeight);
  for (int i = 0; i < 5; ++i) {
    writer.write({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() / 2)});
    const Result<FramePtr> cut = source->next(clock.now() + kPatience);
    ASSERT_FALSE(cut);
    EXPECT_EQ(cut.error().code, Errc::Corrupt);
    writer.write(whole);
    const Result<FramePtr> good = source->next(clock.now() + kPatience);
    ASSERT_TRUE(good) << good.error().what;
    EXPECT_EQ((*good)->sequence, static_cast<std::uint64_t>(2 * i + 1));
  }
}

TEST(LoopbackErrors, AFormatThatIsNotSentIsRefusedWithTheOneThatIs) {
  bridges::MonotonicClock clock;
  LoopbackWriter writer(device(), V4L2_PIX_FMT_RGB24, kWidth, kHeight);
  try {
    open_source("v4l2:" + device() + "?format=YUYV", {&clock, nullptr, nullptr});
    FAIL() << "opened";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.text(), HasSubstr("does not offer YUYV, only RGB24"));
  }
}

}  // namespace
}  // namespace eyebridge::camera::testing
