#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/source.hpp"
#include "eyebridge/camera/video_writer.hpp"
#include "fake_clock.hpp"
#include "picture_files.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::HasSubstr;

Frame plain(int width, int height, std::uint8_t red) {
  Frame frame{width, height, 3 * width, PixelFormat::Rgb24, Time{0}, 0, {}, {}};
  for (int i = 0; i < width * height; ++i) frame.bytes.insert(frame.bytes.end(), {red, 0, 0});
  return frame;
}

class MadeVideo : public ::testing::TestWithParam<const char*> {
 protected:
  Folder folder_;
  const std::string file_ = folder_ / GetParam();
};

TEST_P(MadeVideo, CanBeReadAsACamera) {
  {
    const auto video = make_video(file_, {64, 48}, 25.0);
    for (int i = 0; i < 10; ++i) video->add(plain(64, 48, static_cast<std::uint8_t>(20 * i)));
  }
  FakeClock clock;
  const auto source = open_source("frames:" + file_, {&clock, nullptr, nullptr});
  EXPECT_EQ(source->natural_size(), (Size{64, 48}));
  for (int i = 0; i < 10; ++i) {
    const auto frame = source->next(clock.now() + std::chrono::seconds(1));
    ASSERT_TRUE(frame) << i << ": " << frame.error().what;
    EXPECT_NEAR((*frame)->row(20)[3 * 30], 20 * i, 6) << i;
    EXPECT_NEAR((*frame)->row(20)[3 * 30 + 2], 0, 6) << "red comes first";
  }
}

TEST_P(MadeVideo, TakesPicturesOfItsSizeOnly) {
  const auto video = make_video(file_, {64, 48}, 25.0);
  EXPECT_THROW(video->add(plain(48, 64, 0)), std::runtime_error);
  Frame grey{64, 48, 64, PixelFormat::Grey8, Time{0}, 0, {}, {}};
  grey.bytes.resize(64UL * 48);
  EXPECT_THROW(video->add(grey), std::runtime_error);
}

INSTANTIATE_TEST_SUITE_P(Endings, MadeVideo, ::testing::Values("film.mp4", "film.avi"));

std::string complaint(const std::string& file) {
  try {
    make_video(file, {64, 48}, 25.0);
    return "";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(MakeVideo, SaysWhatIsWrongWithThePlace) {
  EXPECT_THAT(complaint("film.mpeg"), HasSubstr("expected a video's: .mp4 or .avi"));
  EXPECT_THAT(complaint("/nowhere/film.mp4"),
              HasSubstr("/nowhere/film.mp4: cannot be written: No such file"));
}

}  // namespace
}  // namespace eyebridge::camera::testing
