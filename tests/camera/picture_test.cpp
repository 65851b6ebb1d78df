#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/png.hpp"
#include "picture_files.hpp"
#include "sources/frame_errors.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::HasSubstr;

Frame random_frame(int width, int height, PixelFormat format) {
  Frame frame = make_frame(width, height, format);
  Random random(11);
  for (std::uint8_t& byte : frame.bytes) byte = static_cast<std::uint8_t>(random.bits());
  return frame;
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string read_error(const std::filesystem::path& path) {
  try {
    read_png(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Png, ColourPicturesComeBackAsTheyWere) {
  const Folder folder;
  const Frame frame = random_frame(61, 43, PixelFormat::Rgb24);
  write_png(frame, folder / "a.png");
  const Frame back = read_png(folder / "a.png");
  EXPECT_EQ(back.width, 61);
  EXPECT_EQ(back.height, 43);
  EXPECT_EQ(back.format, PixelFormat::Rgb24);
  EXPECT_EQ(back.bytes, frame.bytes);
}

TEST(Png, GreyAndBgraPicturesComeBackAsRgb) {
  const Folder folder;
  const Frame grey = random_frame(20, 9, PixelFormat::Grey8);
  write_png(grey, folder / "grey.png");
  EXPECT_EQ(read_png(folder / "grey.png").bytes, to_rgb24(grey).bytes);

  Frame bgra = random_frame(20, 9, PixelFormat::Bgra32);
  for (std::size_t i = 3; i < bgra.bytes.size(); i += 4) bgra.bytes[i] = 255;
  write_png(bgra, folder / "bgra.png");
  EXPECT_EQ(read_png(folder / "bgra.png").bytes, to_rgb24(bgra).bytes);
}

TEST(Png, RowsMayBePadded) {
  const Folder folder;
  const Frame tight = random_frame(5, 4, PixelFormat::Rgb24);
  Frame padded = tight;
  padded.stride = 32;
  padded.bytes.assign(32 * 4, 77);
  for (int y = 0; y < 4; ++y) {
    std::copy(tight.row(y).begin(), tight.row(y).end(), padded.bytes.begin() + 32 * y);
  }
  write_png(padded, folder / "padded.png");
  EXPECT_EQ(read_png(folder / "padded.png").bytes, tight.bytes);
}

TEST(Png, ABadFileIsAnErrorThatNamesIt) {
  const Folder folder;
  write_text(folder / "junk.png", "this is not a picture, and never was one");
  write_text(folder / "empty.png", "");
  write_png(random_frame(64, 64, PixelFormat::Rgb24), folder / "whole.png");
  std::filesystem::copy_file(folder / "whole.png", folder / "cut.png");
  std::filesystem::resize_file(folder / "cut.png", 5000);
  for (const char* name : {"junk.png", "empty.png", "cut.png", "missing.png"}) {
    EXPECT_THAT(read_error(folder / name), HasSubstr(name));
  }
  EXPECT_EQ(read_error(folder / "whole.png"), "");
}

TEST(Png, DamagedFilesNeverCrashTheReader) {
  const Folder folder;
  write_png(random_frame(16, 16, PixelFormat::Rgb24), folder / "whole.png");
  std::ifstream in(folder / "whole.png", std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(in)), {});
  Random random(5);
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    std::string bytes = whole;
    bytes[random.bits() % bytes.size()] = static_cast<char>(random.bits());
    write_text(folder / "bad.png", bytes);
    if (!read_error(folder / "bad.png").empty()) ++refused;
  }
  EXPECT_GT(refused, 100);  // check sums find nearly all
}

TEST(Png, AFolderThatIsNotThereIsAnErrorThatNamesTheFile) {
  try {
    write_png(random_frame(4, 4, PixelFormat::Rgb24), "/nowhere/at/all.png");
    FAIL() << "nothing thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/at/all.png"));
  }
}

TEST(Convert, GreyIsTheMeanRoundedDown) {
  Frame frame = make_frame(3, 1, PixelFormat::Rgb24);
  frame.bytes = {255, 255, 255, 10, 20, 32, 0, 0, 2};
  frame.time = Time(5);
  frame.sequence = 9;
  const Frame grey = to_grey8(frame);
  EXPECT_EQ(grey.bytes, (std::vector<std::uint8_t>{255, 20, 0}));
  EXPECT_EQ(grey.time, Time(5));
  EXPECT_EQ(grey.sequence, 9U);
  EXPECT_EQ(to_rgb24(grey).bytes, (std::vector<std::uint8_t>{255, 255, 255, 20, 20, 20, 0, 0, 0}));
}

TEST(Convert, FitCutsToTheAspectAndAverages) {
  Frame frame = make_frame(8, 2, PixelFormat::Grey8);
  frame.bytes = {9, 9, 10, 20, 50, 60, 9, 9,  //
                 9, 9, 30, 40, 70, 80, 9, 9};
  EXPECT_EQ(fit(frame, 2, 1).bytes, (std::vector<std::uint8_t>{25, 65}));
  EXPECT_EQ(fit(frame, 4, 2).bytes, (std::vector<std::uint8_t>{10, 20, 50, 60, 30, 40, 70, 80}));
}

TEST(Convert, FitEnlargesByRepeating) {
  Frame frame = make_frame(2, 1, PixelFormat::Grey8);
  frame.bytes = {7, 200};
  EXPECT_EQ(fit(frame, 4, 2).bytes, (std::vector<std::uint8_t>{7, 7, 200, 200, 7, 7, 200, 200}));
}

TEST(Noise, GaussianNoiseHasTheSigmaAskedFor) {
  Frame frame = make_frame(320, 240, PixelFormat::Rgb24);
  std::fill(frame.bytes.begin(), frame.bytes.end(), std::uint8_t{128});
  FrameErrors().apply({{0.0, 8.0}, 3}, 0, frame);
  double sum = 0.0;
  double squares = 0.0;
  for (const std::uint8_t byte : frame.bytes) {
    sum += byte - 128.0;
    squares += (byte - 128.0) * (byte - 128.0);
  }
  const auto count = static_cast<double>(frame.bytes.size());
  EXPECT_NEAR(sum / count, 0.0, 0.1);
  EXPECT_NEAR(std::sqrt(squares / count), 8.0, 0.1);
}

TEST(Noise, SaltAndPepperTurnsTheFractionAskedFor) {
  Frame frame = make_frame(320, 240, PixelFormat::Rgb24);
  std::fill(frame.bytes.begin(), frame.bytes.end(), std::uint8_t{128});
  FrameErrors().apply({{0.1}, 3}, 0, frame);
  int black = 0;
  int white = 0;
  for (std::size_t i = 0; i < frame.bytes.size(); i += 3) {
    black += frame.bytes[i] == 0 && frame.bytes[i + 1] == 0 && frame.bytes[i + 2] == 0 ? 1 : 0;
    white += frame.bytes[i] == 255 && frame.bytes[i + 2] == 255 ? 1 : 0;
  }
  EXPECT_NEAR(black / 76800.0, 0.05, 0.005);
  EXPECT_NEAR(white / 76800.0, 0.05, 0.005);
}

}  // namespace
}  // namespace eyebridge::camera::testing
