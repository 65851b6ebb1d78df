// Videos as cameras.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/videoio.hpp>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/source.hpp"
#include "fake_clock.hpp"
#include "picture_files.hpp"
#include "quicktime.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::HasSubstr;

constexpr Time kLong = std::chrono::seconds(100);
constexpr int kStep = 12;  // of brightness, from frame to frame

class Video : public ::testing::Test {
 protected:
  /// An AVI of `count` frames, 25 a second, 64 x 48 pixels: the left half brighter from frame to
  /// frame, the right half blue.
  void write(int count) {
    cv::VideoWriter writer(file_, cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                           25.0, {64, 48});
    ASSERT_TRUE(writer.isOpened());
    for (int i = 0; i < count; ++i) {
      cv::Mat picture(48, 64, CV_8UC3, cv::Scalar(255, 0, 0));
      picture.colRange(0, 32).setTo(cv::Scalar::all(kStep * i));
      writer.write(picture);
    }
  }
  void open(const std::string& options = "") {
    source_ = open_source("frames:" + file_ + options, {&clock_, nullptr, nullptr});
  }
  /// The number of the next frame; -1 when there is none, which error_ then tells.
  int next() {
    const Result<FramePtr> frame = source_->next(clock_.now() + kLong);
    if (!frame) {
      error_ = frame.error();
      return -1;
    }
    last_ = *frame;
    return (last_->row(24)[3 * 8] + kStep / 2) / kStep;
  }
  std::string complaint() {
    try {
      open();
      return "";
    } catch (const ConfigError& error) {
      EXPECT_EQ(error.where().file, "--camera");
      return error.text();
    }
  }

  Folder folder_;
  std::string file_ = folder_ / "video.avi";
  FakeClock clock_;
  std::unique_ptr<Source> source_;
  FramePtr last_;
  Error error_;
};

TEST_F(Video, FramesComeInOrderAtTheTimesOfTheVideo) {
  write(20);
  open();
  EXPECT_EQ(source_->natural_size(), (Size{64, 48}));
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(next(), i);
    EXPECT_EQ(last_->sequence, static_cast<std::uint64_t>(i));
    EXPECT_NEAR(to_seconds(last_->time), 0.04 * i, 1e-6);
    EXPECT_EQ(clock_.now(), last_->time);
  }
  EXPECT_EQ(next(), -1);
  EXPECT_EQ(error_.code, Errc::Disconnected);
}

TEST_F(Video, ColoursAreInTheirPlaces) {
  write(2);
  open();
  next();
  const auto pixel = last_->row(24).subspan(3 * 48, 3);
  EXPECT_LT(pixel[0], 40);
  EXPECT_LT(pixel[1], 40);
  EXPECT_GT(pixel[2], 215);
}

TEST_F(Video, ASlowProgramGetsTheNewest) {
  write(20);
  open();
  EXPECT_EQ(next(), 0);
  clock_.spend(std::chrono::milliseconds(210));
  EXPECT_EQ(next(), 5);
  EXPECT_EQ(last_->sequence, 5U);
  EXPECT_EQ(next(), 6);
}

TEST_F(Video, ItCanLoopAndHold) {
  write(4);
  open("?end=loop");
  for (const int expected : {0, 1, 2, 3, 0, 1}) EXPECT_EQ(next(), expected);
  EXPECT_NEAR(to_seconds(last_->time), 0.2, 1e-6);
  clock_.spend(std::chrono::seconds(16));  // a hundred rounds
  EXPECT_EQ(next(), 1);
  EXPECT_EQ(last_->sequence, 405U);
  open("?end=hold");
  for (const int expected : {0, 1, 2, 3, 3, 3}) EXPECT_EQ(next(), expected);
}

TEST_F(Video, OneThatIsCutEndsWithTheLastFrameThatIsThere) {
  // How many there should be is an estimate: of a video that was cut without loss it is wrong.
  write(20);
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) / 2);
  open();
  int frames = 0;
  ::testing::internal::CaptureStderr();
  while (next() >= 0) ++frames;
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "FFmpeg has nothing to say";
  EXPECT_GT(frames, 3);
  EXPECT_LT(frames, 18);
  EXPECT_EQ(error_.code, Errc::Disconnected);
}

class StrangersVideo : public ::testing::Test {
 protected:
  /// Times of all frames, seconds; each must come.
  std::vector<double> times(const std::string& url) {
    const auto source = open_source("frames:" + kCases + url, {&clock_, nullptr, nullptr});
    std::vector<double> out;
    while (out.size() < 1000) {
      const auto frame = source->next(clock_.now() + std::chrono::seconds(10));
      if (!frame) {
        EXPECT_EQ(frame.error().code, Errc::Disconnected) << frame.error().what;
        break;
      }
      out.push_back(to_seconds((*frame)->time));
    }
    return out;
  }

  const std::string kCases = EYEBRIDGE_SHARED_DIR "/cases/videos/";
  FakeClock clock_;
};

TEST_F(StrangersVideo, CutWithoutLossHasAllItsFramesAndNoComplaint) {
  EXPECT_EQ(times("cutstart.mp4?pick=each").size(), 24U);
}

TEST_F(StrangersVideo, JpegsAloneAreTwentyFiveASecondOrAsManyAsAskedFor) {
  const auto usual = times("raw.mjpeg?pick=each");
  ASSERT_EQ(usual.size(), 30U);
  EXPECT_NEAR(usual.back() - usual.front(), 29 / 25.0, 1e-6);
  const auto slow = times("raw.mjpeg?pick=each&fps=10");
  ASSERT_EQ(slow.size(), 30U);
  EXPECT_NEAR(slow.back() - slow.front(), 2.9, 1e-6);
}

/// Six frames, each grey by its number, none as long as the one before.
Film film_of_six() {
  Film film;
  film.width = 64;
  film.height = 48;
  for (int i = 0; i < 6; ++i) {
    Frame frame = make_frame(64, 48, PixelFormat::Rgb24);
    std::ranges::fill(frame.bytes, static_cast<std::uint8_t>(40 * i));
    film.shots.push_back({jpeg_of(frame, TJSAMP_444, 0), static_cast<std::uint32_t>(20 + 30 * i)});
  }
  return film;
}

TEST_F(Video, FramesOfVaryingDurationComeAtTheirOwnTimes) {
  file_ = folder_ / "film.mov";
  folder_.write("film.mov", film_of_six().file());
  open("?pick=each");
  std::vector<double> times;
  for (int i = 0; i < 6; ++i) {
    ASSERT_GE(next(), 0) << error_.what;
    EXPECT_NEAR(last_->row(24)[30], 40 * i, 3);
    times.push_back(to_seconds(last_->time));
  }
  EXPECT_EQ(next(), -1);
  double due = times[0];
  for (int i = 0; i < 5; ++i) {
    due += 0.02 + 0.03 * i;
    EXPECT_NEAR(times[static_cast<std::size_t>(i) + 1], due, 0.001) << "frame " << i + 1;
  }
}

TEST_F(Video, PixelsThatAreNotSquareAreMadeSo) {
  Film film = film_of_six();
  film.pixel_width = 16;
  film.pixel_height = 11;
  file_ = folder_ / "film.mov";
  folder_.write("film.mov", film.file());
  open("?pick=each");
  EXPECT_EQ(source_->natural_size(), (Size{93, 48}));  // 64 * 16 / 11
  ASSERT_TRUE(source_->set_size(93, 48));
  for (int i = 0; i < 6; ++i) {
    ASSERT_GE(next(), 0) << error_.what;
    EXPECT_EQ(last_->width, 93);
    EXPECT_NEAR(last_->row(24)[3 * 90], 40 * i, 3);
  }
}

TEST_F(Video, WhatAnEditCutsOffIsNotShown) {
  Film film = film_of_six();
  film.begins_at = 70;  // after the first two, of 20 and 50 ms
  file_ = folder_ / "film.mov";
  folder_.write("film.mov", film.file());
  open("?pick=each");
  const double begin = to_seconds(clock_.now());
  for (int i = 2; i < 6; ++i) {
    ASSERT_GE(next(), 0) << error_.what;
    EXPECT_NEAR(last_->row(24)[30], 40 * i, 3);
    if (i == 3) {
      EXPECT_NEAR(to_seconds(last_->time) - begin, 0.08, 0.001);
    }
  }
  EXPECT_EQ(next(), -1);
}

TEST_F(Video, WhatIsNoVideoIsRefusedWithOneMessage) {
  folder_.write("video.avi", Bytes(5000, 'x'));
  ::testing::internal::CaptureStderr();
  EXPECT_THAT(complaint(),
              HasSubstr("video.avi: found no video that can be read, expected a video"));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  folder_.write("video.avi", {});
  EXPECT_THAT(complaint(), HasSubstr("found no video that can be read"));
}

}  // namespace
}  // namespace eyebridge::camera::testing
