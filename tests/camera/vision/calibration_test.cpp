#include "eyebridge/camera/calibration.hpp"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/source.hpp"
#include "fake_clock.hpp"
#include "lens_effects.hpp"
#include "optics/lens_distortion.hpp"
#include "optics/undistortion.hpp"
#include "sources/undistorted_source.hpp"
#include "sources/url_option.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::HasSubstr;

Calibration webcam() {
  Calibration lens = pinhole({640, 480}, deg_to_rad(60.0));
  lens.distortion = {-0.28, 0.07, 0.0008, -0.0012, 0.01};
  lens.cx += 3.5;
  lens.fy *= 1.01;
  lens.error = 0.25;
  return lens;
}

TEST(Pinhole, SeesItsFieldOfViewFromEdgeToEdge) {
  const Calibration lens = pinhole({640, 480}, deg_to_rad(90.0));
  EXPECT_NEAR(lens.fx, 320.0, 1e-9);
  EXPECT_NEAR(lens.fy, 320.0, 1e-9);
  EXPECT_NEAR(lens.cx, 319.5, 1e-12);
  EXPECT_NEAR(lens.cy, 239.5, 1e-12);
}

TEST(Scaled, APictureOfHalfTheSizeIsThatOfAPinholeOfThatSize) {
  const Calibration half = scaled(pinhole({640, 480}, 1.0), {320, 240});
  const Calibration expected = pinhole({320, 240}, 1.0);
  EXPECT_NEAR(half.fx, expected.fx, 1e-9);
  EXPECT_NEAR(half.cx, expected.cx, 1e-9);
  EXPECT_NEAR(half.cy, expected.cy, 1e-9);
  EXPECT_EQ(half.size, (Size{320, 240}));
}

TEST(Scaled, APictureOfAnotherAspectIsCutAboutTheMiddle) {
  const Calibration square = scaled(pinhole({640, 480}, 1.0), {240, 240});
  EXPECT_NEAR(square.fx, 0.5 * pinhole({640, 480}, 1.0).fx, 1e-9);
  EXPECT_NEAR(square.cx, 119.5, 1e-9);
  EXPECT_NEAR(square.cy, 119.5, 1e-9);
  EXPECT_THROW(scaled(square, {0, 10}), std::invalid_argument);
}

TEST(Distortion, IsBrownsFormula) {
  Calibration lens = webcam();
  lens.distortion = {0.1, 0.02, 0.003, 0.004, 0.005};
  // r^2 = 0.13 at (0.3, 0.2); by hand.
  const double radial = 1.0 + 0.1 * 0.13 + 0.02 * 0.0169 + 0.005 * 0.002197;
  const Vec2 out = distorted(lens, {0.3, 0.2});
  EXPECT_NEAR(out.x, 0.3 * radial + 2 * 0.003 * 0.06 + 0.004 * (0.13 + 2 * 0.09), 1e-12);
  EXPECT_NEAR(out.y, 0.2 * radial + 0.003 * (0.13 + 2 * 0.04) + 2 * 0.004 * 0.06, 1e-12);
}

TEST(Distortion, CanBeUndoneAllOverThePicture) {
  const Calibration lens = webcam();
  for (int y = 0; y < 480; y += 40) {
    for (int x = 0; x < 640; x += 40) {
      const Vec2 seen = to_plane(lens, {x * 1.0, y * 1.0});
      EXPECT_LT(norm(distorted(lens, undistorted(lens, seen)) - seen), 1e-9);
    }
  }
}

TEST(Undistortion, ALensPictureBecomesThatOfAPinhole) {
  world::WorldModel model;
  model.width = model.height = 1.0;
  model.walls = {{{1.0, 0.0}, {1.0, 1.0}}, {{0.0, 1.0}, {1.0, 1.0}}};
  const WallPainter painter(model, place_fiducials(model));
  const EyePose eye{{0.3, 0.3, 0.12, 0.7, 0.0, 0.0}};
  const Effects clean{.blur = 0.8, .noise = 0.0};
  Random random(1);
  const Calibration lens = webcam();
  Calibration straight = lens;
  straight.distortion = {};
  const Frame expected = LensCamera(painter, straight).take(eye, eye, clean, random);
  const Frame bent = LensCamera(painter, lens).take(eye, eye, clean, random);
  const Frame undone = Undistortion(lens).apply(bent);
  const auto difference = [&](const Frame& frame) {
    double sum = 0.0;
    int count = 0;
    for (int y = 8; y < 472; ++y) {
      for (int x = 8; x < 632; ++x, ++count) {
        sum += std::abs(frame.row(y)[static_cast<std::size_t>(x)] -
                        expected.row(y)[static_cast<std::size_t>(x)]);
      }
    }
    return sum / count;
  };
  EXPECT_GT(difference(bent), 3.5);
  EXPECT_LT(difference(undone), 1.5);
}

TEST(Undistortion, WithoutDistortionNothingChanges) {
  Frame frame;
  frame.width = 8;
  frame.height = 6;
  frame.stride = 26;  // two bytes of padding
  frame.format = PixelFormat::Rgb24;
  frame.sequence = 5;
  frame.time = Time(7);
  for (int i = 0; i < 26 * 6; ++i) frame.bytes.push_back(static_cast<std::uint8_t>(i));
  const Frame same = Undistortion(pinhole({8, 6}, 1.0)).apply(frame);
  for (int y = 0; y < 6; ++y) {
    EXPECT_TRUE(std::ranges::equal(same.row(y), frame.row(y))) << y;
  }
  EXPECT_EQ(same.sequence, 5U);
  EXPECT_EQ(same.time, Time(7));
}

TEST(Undistortion, WhatTheLensDidNotSeeIsBlack) {
  Calibration cushion = pinhole({64, 48}, deg_to_rad(60.0));
  cushion.distortion[0] = 0.3;
  Frame white;
  white.width = white.stride = 64;
  white.height = 48;
  white.format = PixelFormat::Grey8;
  white.bytes.assign(64 * 48, 255);
  const Frame out = Undistortion(cushion).apply(white);
  EXPECT_EQ(out.bytes.front(), 0);
  EXPECT_EQ(out.row(24)[32], 255);
}

TEST(CalibrationText, SurvivesBeingWrittenAndRead) {
  EXPECT_EQ(parse_calibration(to_toml(webcam()), "cam.toml"), webcam());
  EXPECT_EQ(parse_calibration(to_toml(pinhole({640, 480}, 1.0)), "cam.toml"),
            pinhole({640, 480}, 1.0));
}

TEST(CalibrationText, OfRosIsRead) {
  const Calibration lens = read_calibration(EYEBRIDGE_SHARED_DIR "/cases/calibration/ost.yaml");
  Calibration expected;
  expected.size = {640, 480};
  expected.fx = 543.2;
  expected.cx = 321.0;
  expected.fy = 543.1;
  expected.cy = 241.0;
  expected.distortion = {-0.48, 0.18, -0.0019, 0.0028, 0.0};
  EXPECT_EQ(lens, expected);
}

struct BadText {
  const char* name;
  const char* text;
  const char* place;
  const char* message;
};
void PrintTo(const BadText& bad, std::ostream* out) { *out << bad.name; }

class BadCalibration : public ::testing::TestWithParam<BadText> {};

TEST_P(BadCalibration, IsOneErrorWithItsPlace) {
  try {
    parse_calibration(GetParam().text, "cam.toml");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_EQ(error.where().str(), GetParam().place);
    EXPECT_THAT(error.text(), HasSubstr(GetParam().message));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Texts, BadCalibration,
    ::testing::Values(BadText{"Empty", "", "cam.toml", "no 'size'"},
                      BadText{"NoToml", "size = [640, 480\n]]", "cam.toml:2:2", ""},
                      BadText{"UnknownKey", "size = [640, 480]\nfocus = 3\n", "cam.toml:2:1",
                              "'focus'"},
                      BadText{"OneSide", "size = [640]", "cam.toml:1:8", "list of 2"},
                      BadText{"Text", "size = [640, \"480\"]", "cam.toml:1:14", "a number"},
                      BadText{"NoPixels", "size = [0, 480]", "cam.toml:1:9", "expected 1"},
                      BadText{"HalfPixels", "size = [640.5, 480]", "cam.toml:1:8", "whole pixels"},
                      BadText{"NoFocalLength", "size = [640, 480]\nfocal_length = [-3, 500]",
                              "cam.toml:2:17", "-3"},
                      BadText{"NotANumber", "size = [640, 480]\nfocal_length = [nan, 500]",
                              "cam.toml:2:17", "nan"},
                      BadText{"Fisheye",
                              "image_width: 640\nimage_height: 480\ncamera_matrix: [500, 0, 320, "
                              "0, 500, 240, 0, 0, 1]\ndistortion_model: equidistant\n"
                              "distortion_coefficients: [0, 0, 0, 0]\n",
                              "cam.toml:4:19", "expected plumb_bob"},
                      BadText{"NoMatrix", "image_width: 640\nimage_height: 480\ncamera_matrix: 3\n",
                              "cam.toml:3:16", "a matrix with its 'data'"},
                      BadText{"EightCoefficients",
                              "image_width: 640\nimage_height: 480\ncamera_matrix: [500, 0, 320, "
                              "0, 500, 240, 0, 0, 1]\n"
                              "distortion_coefficients: [0, 0, 0, 0, 0, 0.1, 0, 0]\n",
                              "cam.toml:4:26", "found 8 distortion coefficients"},
                      BadText{"Umlaut", "# \xC3\xA4\n", "cam.toml:1:3", "ASCII"}),
    [](const auto& test) { return std::string(test.param.name); });

class CalibratedSource : public ::testing::Test {
 protected:
  std::string write(const Calibration& lens) {
    // Other presets run the same test at the same time.
    std::string path =
        ::testing::TempDir() + "/eyebridge_lens_" + std::to_string(getpid()) + ".toml";
    write_calibration(lens, path);
    return path;
  }
  std::string error_of(const std::string& url) {
    try {
      open_source(url, {&clock_, nullptr, nullptr});
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
  FakeClock clock_;
};

TEST_F(CalibratedSource, ItsPicturesAreStraightened) {
  Calibration lens = webcam();
  const std::string file = write(lens);
  const auto bent = open_source("pattern", {&clock_, nullptr, nullptr});
  FakeClock other;
  const auto straight = open_source("pattern?calibration=" + file, {&other, nullptr, nullptr});
  ASSERT_TRUE(bent->set_size(320, 240));
  ASSERT_TRUE(straight->set_size(320, 240));
  const FramePtr from = *bent->next(Time(1'000'000'000));
  const FramePtr to = *straight->next(Time(1'000'000'000));
  EXPECT_EQ(to->sequence, from->sequence);
  EXPECT_EQ(to->time, from->time);
  EXPECT_EQ(to->bytes, Undistortion(scaled(lens, {320, 240})).apply(*from).bytes);
  EXPECT_NE(to->bytes, from->bytes);
}

TEST_F(CalibratedSource, AnotherAspectIsAnErrorThatNamesBoth) {
  const std::string file = write(scaled(webcam(), {1280, 720}));
  const std::string error = error_of("pattern?calibration=" + file);
  EXPECT_THAT(error, HasSubstr("1280x720"));
  EXPECT_THAT(error, HasSubstr("320x240"));
}

TEST_F(CalibratedSource, AnAspectThatIsAskedForLaterIsUnsupported) {
  const auto source =
      open_source("pattern?calibration=" + write(webcam()), {&clock_, nullptr, nullptr});
  EXPECT_TRUE(source->set_size(160, 120));
  const auto result = source->set_size(160, 90);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, Errc::Unsupported);
  EXPECT_THAT(result.error().what, HasSubstr("640x480"));
}

TEST_F(CalibratedSource, AFileThatIsMissingOrEmptyNamedOrNamedTwiceIsAnError) {
  EXPECT_THAT(error_of("pattern?calibration=no-such-file.toml"), HasSubstr("no-such-file.toml"));
  EXPECT_THAT(error_of("pattern?calibration=."), HasSubstr("is not a file"));
  EXPECT_THAT(error_of("pattern?calibration="), HasSubstr("calibration"));
  const std::string file = write(webcam());
  EXPECT_THAT(error_of("pattern?calibration=" + file + "&calibration=" + file),
              HasSubstr("second"));
  const SourceContext context{&clock_, nullptr, nullptr};
  EXPECT_THROW(check_source("pattern?calibration=no-such-file.toml", context), ConfigError);
}

TEST(TakeOption, LeavesTheOtherOptionsToTheSource) {
  const auto take = [](const char* url) {
    return take_option(url, "calibration", "calibration=FILE");
  };
  EXPECT_EQ(take("v4l2:/dev/video0?size=640x480&calibration=a.toml&fps=30").url,
            "v4l2:/dev/video0?size=640x480&fps=30");
  EXPECT_EQ(take("v4l2:/dev/video0?calibration=a.toml").url, "v4l2:/dev/video0");
  EXPECT_EQ(take("render:egl").url, "render:egl");
  EXPECT_EQ(*take("render?calibration=a.toml").value, "a.toml");
}

}  // namespace
}  // namespace eyebridge::camera::testing
