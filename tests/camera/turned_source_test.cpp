// Cameras as they are mounted: rotate= and flip= of every source.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/source.hpp"
#include "fake_clock.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::HasSubstr;

class TurnedSource : public ::testing::Test {
 protected:
  /// The first picture of the pattern, which is different everywhere.
  Frame picture(const std::string& options, int width = 64, int height = 48) {
    FakeClock clock;
    const auto source = open_source("pattern" + options, {&clock, nullptr, nullptr});
    EXPECT_TRUE(source->set_size(width, height));
    const auto frame = source->next(std::chrono::seconds(10));
    EXPECT_TRUE(frame) << frame.error().what;
    return frame ? **frame : Frame{};
  }
  static std::vector<std::uint8_t> pixel(const Frame& frame, int x, int y) {
    const auto bytes = frame.row(y).subspan(static_cast<std::size_t>(3 * x), 3);
    return {bytes.begin(), bytes.end()};
  }
};

TEST_F(TurnedSource, TurnsClockwiseAndMirrors) {
  const Frame plain = picture("");
  const Frame on_side = picture("", 48, 64);
  struct Row {
    const char* options;
    std::function<std::vector<std::uint8_t>(int x, int y)> from;
  };
  const Row rows[] = {
      {"?rotate=0", [&](int x, int y) { return pixel(plain, x, y); }},
      {"?rotate=90", [&](int x, int y) { return pixel(on_side, y, 63 - x); }},
      {"?rotate=180", [&](int x, int y) { return pixel(plain, 63 - x, 47 - y); }},
      {"?rotate=270", [&](int x, int y) { return pixel(on_side, 47 - y, x); }},
      {"?flip=h", [&](int x, int y) { return pixel(plain, 63 - x, y); }},
      {"?flip=v", [&](int x, int y) { return pixel(plain, x, 47 - y); }},
      {"?rotate=90&flip=h", [&](int x, int y) { return pixel(on_side, y, x); }},
      {"?flip=v&rotate=90", [&](int x, int y) { return pixel(on_side, 47 - y, 63 - x); }},
      {"?rotate=180&flip=h", [&](int x, int y) { return pixel(plain, x, 47 - y); }},
      {"?rotate=270&flip=v", [&](int x, int y) { return pixel(on_side, y, x); }},
  };
  for (const Row& row : rows) {
    const Frame turned = picture(row.options);
    ASSERT_EQ(turned.width, 64) << row.options;
    ASSERT_EQ(turned.height, 48) << row.options;
    int wrong = 0;
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) wrong += pixel(turned, x, y) == row.from(x, y) ? 0 : 1;
    }
    EXPECT_EQ(wrong, 0) << row.options;
  }
}

TEST_F(TurnedSource, OtherWordsAreRefused) {
  FakeClock clock;
  const auto complaint = [&](const std::string& url) -> std::string {
    try {
      open_source(url, {&clock, nullptr, nullptr});
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_THAT(complaint("pattern?rotate=45"), HasSubstr("expected rotate=90, 180 or 270"));
  EXPECT_THAT(complaint("pattern?flip=both"), HasSubstr("expected flip=h or flip=v"));
}

}  // namespace
}  // namespace eyebridge::camera::testing
