// What a camera's errors do to pictures: how often, how much, how spread, and which seed they
// follow.
#include "sources/frame_errors.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/source.hpp"
#include "fake_clock.hpp"
#include "fake_view.hpp"
#include "frame_files.hpp"
#include "scenes.hpp"
#include "statistics.hpp"

namespace eyebridge::camera::testing {
namespace {

using namespace eyebridge::testing;
using ::testing::HasSubstr;

Frame even_frame(std::uint8_t tone, int width = 80, int height = 60) {
  Frame frame = make_frame(width, height, PixelFormat::Rgb24);
  std::fill(frame.bytes.begin(), frame.bytes.end(), tone);
  return frame;
}

Frame erring(const robot::CameraError& error, Frame frame, std::uint64_t moment = 0,
             std::uint64_t seed = 3) {
  FrameErrors().apply({error, seed}, moment, frame);
  return frame;
}

/// Only `member` of the errors, at `value`.
robot::CameraError only(double robot::CameraError::*member, double value) {
  robot::CameraError error;
  error.*member = value;
  return error;
}

TEST(CameraErrors, APerfectCameraChangesNoByte) {
  const Frame frame = even_frame(77);
  EXPECT_EQ(erring({}, frame).bytes, frame.bytes);
}

TEST(CameraErrors, GaussianNoiseIsNormallyDistributedAndItsChannelsIndependent) {
  constexpr double kSigma = 8;
  // Few pixels against the 16384 draws that the noise is looked up in, whose own spread would show.
  const Frame frame = erring(only(&robot::CameraError::sigma, kSigma), even_frame(128, 40, 30));
  // Bytes are rounded: chi-square over grey levels, the tails as one each.
  constexpr int kReach = 20;
  std::vector<double> counts(2 * kReach + 1);
  std::vector<double> expected(2 * kReach + 1);
  double red_green = 0;
  for (std::size_t i = 0; i < frame.bytes.size(); ++i) {
    const int off = frame.bytes[i] - 128;
    ++counts[static_cast<std::size_t>(std::clamp(off, -kReach, kReach) + kReach)];
    if (i % 3 == 0) red_green += off * (frame.bytes[i + 1] - 128.0);
  }
  const auto count = static_cast<double>(frame.bytes.size());
  double below = 0;
  for (int off = -kReach; off <= kReach; ++off) {
    const double up_to = off == kReach ? 1.0 : normal_cdf(off + 0.5, 0, kSigma);
    expected[static_cast<std::size_t>(off + kReach)] = count * (up_to - below);
    below = up_to;
  }
  EXPECT_GT(chi_square_p_value(counts, expected), kUnlikely);
  EXPECT_NEAR(red_green / (count / 3) / (kSigma * kSigma), 0, 4 / std::sqrt(count / 3));
}

TEST(CameraErrors, SaltAndPepperAreAsManyOfEach) {
  constexpr double kShare = 0.06;
  const Frame frame = erring(only(&robot::CameraError::salt_and_pepper, kShare), even_frame(128));
  std::vector<double> counts(3);  // black, white, as it was
  for (std::size_t i = 0; i < frame.bytes.size(); i += 3) {
    EXPECT_EQ(frame.bytes[i], frame.bytes[i + 1]);
    EXPECT_EQ(frame.bytes[i], frame.bytes[i + 2]);
    ++counts[frame.bytes[i] == 0 ? 0 : frame.bytes[i] == 255 ? 1 : 2];
  }
  const double pixels = 80 * 60;
  EXPECT_GT(
      chi_square_p_value(counts, {pixels * kShare / 2, pixels * kShare / 2, pixels * (1 - kShare)}),
      kUnlikely);
}

TEST(CameraErrors, ColouredPixelsAreAsManyAsAskedForAndOfAnyColour) {
  constexpr double kShare = 0.25;
  const Frame frame =
      erring(only(&robot::CameraError::coloured, kShare), even_frame(128, 160, 120));
  std::vector<double> tones(16);  // of all channels
  double coloured = 0;
  for (std::size_t i = 0; i < frame.bytes.size(); i += 3) {
    if (frame.bytes[i] == 128 && frame.bytes[i + 1] == 128 && frame.bytes[i + 2] == 128) continue;
    ++coloured;
    for (std::size_t channel = 0; channel < 3; ++channel) ++tones[frame.bytes[i + channel] / 16];
  }
  EXPECT_GT(binomial_p_value(coloured, 160 * 120, kShare), kUnlikely);
  EXPECT_GT(chi_square_p_value(tones, std::vector<double>(16, coloured * 3 / 16)), kUnlikely);
}

TEST(CameraErrors, ExposureIsInStops) {
  const auto tone = [](double stops, std::uint8_t before) {
    return erring(only(&robot::CameraError::exposure, stops), even_frame(before)).bytes[0];
  };
  EXPECT_EQ(tone(1, 60), 120);
  EXPECT_EQ(tone(-1, 60), 30);
  EXPECT_EQ(tone(0.5, 100), 141);
  EXPECT_EQ(tone(3, 60), 255) << "saturated";
}

TEST(CameraErrors, FlickerIsNormallyDistributedInStopsFromPictureToPicture) {
  constexpr double kSigma = 0.15;
  std::vector<double> stops;
  for (std::uint64_t moment = 0; moment < 2000; ++moment) {
    const Frame frame =
        erring(only(&robot::CameraError::exposure_sigma, kSigma), even_frame(120, 4, 4), moment);
    EXPECT_EQ(frame.bytes.front(), frame.bytes.back()) << "one draw a picture";
    stops.push_back(std::log2(frame.bytes[0] / 120.0));
  }
  expect_normal(stops, 0.0, kSigma);
}

TEST(CameraErrors, BlurSpreadsAPointAsAGaussianAndKeepsItsLight) {
  constexpr double kSigma = 2.5;
  Frame frame = even_frame(0, 320, 60);
  const std::size_t middle = (30 * 320 + 160) * 3 + 1;  // green only
  // A bright square of 9 x 9: its variance is that of the square and that of the blur.
  for (int y = 26; y <= 34; ++y) {
    for (int x = 156; x <= 164; ++x)
      frame.bytes[static_cast<std::size_t>((y * 320 + x) * 3 + 1)] = 250;
  }
  const Frame blurred = erring(only(&robot::CameraError::blur, kSigma), frame);
  EXPECT_LT(blurred.bytes[middle], 250);
  double light = 0;
  double across = 0;
  double down = 0;
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 320; ++x) {
      const std::size_t at = static_cast<std::size_t>((y * 320 + x) * 3);
      EXPECT_EQ(blurred.bytes[at] + blurred.bytes[at + 2], 0) << "another channel";
      const double tone = blurred.bytes[at + 1];
      light += tone;
      across += tone * (x - 160) * (x - 160);
      down += tone * (y - 30) * (y - 30);
    }
  }
  EXPECT_NEAR(light, 81 * 250, 81 * 250 * 0.01);
  const double variance = (9 * 9 - 1) / 12.0 + kSigma * kSigma;
  EXPECT_NEAR(across / light, variance, 0.05 * variance);
  EXPECT_NEAR(down / light, variance, 0.05 * variance);
}

TEST(CameraErrors, BlurOfAnEvenPictureIsThatPictureAndAWiderOneIsBlurredMore) {
  for (const double sigma : {0.1, 1.0, 7.0}) {
    const Frame frame = even_frame(201, 64, 48);
    EXPECT_EQ(erring(only(&robot::CameraError::blur, sigma), frame).bytes, frame.bytes) << sigma;
  }
  const auto edge = [](int width) {
    Frame frame = even_frame(0, width, 4);
    for (std::size_t i = 0; i < frame.bytes.size(); ++i) {
      if (i % static_cast<std::size_t>(3 * width) >= static_cast<std::size_t>(3 * width / 2)) {
        frame.bytes[i] = 255;
      }
    }
    frame = erring(only(&robot::CameraError::blur, 2), frame);
    int grey = 0;
    for (int x = 0; x < width; ++x) {
      const int tone = frame.bytes[static_cast<std::size_t>(3 * x)];
      grey += tone > 40 && tone < 215 ? 1 : 0;
    }
    return grey;
  };
  EXPECT_EQ(edge(320), 4);  // 1 sigma to either side
  EXPECT_EQ(edge(640), 8);
}

TEST(CameraErrors, FollowFromSeedAndMomentAlone) {
  const robot::CameraError all{0.02, 5, 0.02, 1, 0.2, 0.1};
  const Frame frame = even_frame(100);
  EXPECT_EQ(erring(all, frame, 7, 3).bytes, erring(all, frame, 7, 3).bytes);
  EXPECT_NE(erring(all, frame, 8, 3).bytes, erring(all, frame, 7, 3).bytes);
  EXPECT_NE(erring(all, frame, 7, 4).bytes, erring(all, frame, 7, 3).bytes);
}

TEST(CameraErrors, ColouredPixelsDoNotShiftTheOtherNoise) {
  robot::CameraError error;
  error.sigma = 5;
  const Frame without = erring(error, even_frame(100));
  error.coloured = 0.1;
  const Frame with = erring(error, even_frame(100));
  double same = 0;
  for (std::size_t i = 0; i < with.bytes.size(); i += 3) {
    same += std::equal(&with.bytes[i], &with.bytes[i] + 3, &without.bytes[i]) ? 1 : 0;
  }
  EXPECT_GT(binomial_p_value(same, 80 * 60, 0.9), kUnlikely);
}

class ErringSources : public ::testing::Test {
 protected:
  ErringSources() { view_.model = empty_room(); }
  std::vector<std::uint8_t> third_frame(const std::string& url) {
    FakeClock clock;
    const auto source = open_source(url, {&clock, &view_, &log_});
    FramePtr frame;
    for (int i = 0; i < 3; ++i) frame = source->next(clock.now() + Time(2'000'000'000)).value();
    EXPECT_EQ(frame->format, PixelFormat::Rgb24);
    return frame->bytes;
  }
  std::string error_of(const std::string& url) {
    FakeClock clock;
    try {
      check_source(url, {&clock, &view_, &log_});
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  FakeView view_;
  RecordingLog log_;
};

TEST_F(ErringSources, AnySourceErrsAsItsUrlSaysAndTheSameWayEachTime) {
  FrameFiles files;
  for (const std::string& url : {std::string("pattern"), "frames:" + files.folder(5)}) {
    const auto exact = third_frame(url);
    const auto harsh = third_frame(url + "?errors=harsh");
    EXPECT_NE(harsh, exact) << url;
    EXPECT_EQ(third_frame(url + "?errors=harsh"), harsh);
    EXPECT_NE(third_frame(url + "?errors=harsh&error_seed=2"), harsh);
    EXPECT_EQ(third_frame(url + "?errors=perfect"), exact);
    EXPECT_NE(third_frame(url + "?errors=exposure=-1,sigma=2"), harsh);
  }
}

TEST_F(ErringSources, MistakesAreNamed) {
  EXPECT_THAT(error_of("pattern?errors=awful"), HasSubstr("'awful' found: expected salt"));
  EXPECT_THAT(error_of("pattern?errors=sigma=300"), HasSubstr("expected 0 to 255"));
  EXPECT_THAT(error_of("pattern?errors="), HasSubstr("an empty 'errors', expected one errors="));
  EXPECT_THAT(error_of("pattern?errors=harsh&errors=harsh"), HasSubstr("a second 'errors'"));
  EXPECT_THAT(error_of("pattern?errors=harsh&error_seed=x"), HasSubstr("error_seed='x'"));
  EXPECT_THAT(error_of("pattern?error_seed=4"), HasSubstr("beside errors="));
}

}  // namespace
}  // namespace eyebridge::camera::testing
