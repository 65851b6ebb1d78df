#include "eyebridge/camera/sign.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace eyebridge::camera::testing {
namespace {

constexpr Arrow kArrows[] = {Arrow::None,      Arrow::Forward,   Arrow::Backward,   Arrow::TurnLeft,
                             Arrow::TurnRight, Arrow::CurveLeft, Arrow::CurveRight, Arrow::BackLeft,
                             Arrow::BackRight, Arrow::Lost};

/// How many pixels of the left and of the right half above the words are not white.
std::pair<int, int> ink(const Frame& frame) {
  std::pair<int, int> out;
  for (int y = 0; y < frame.height * 6 / 10; ++y) {
    const auto row = frame.row(y);
    for (int x = 0; x < frame.width; ++x) {
      if (row[static_cast<std::size_t>(3 * x)] > 200) continue;
      ++(2 * x < frame.width ? out.first : out.second);
    }
  }
  return out;
}

TEST(Sign, EachArrowIsAPictureOfItsOwn) {
  std::set<std::string> pictures;
  for (const Arrow arrow : kArrows) {
    const Frame frame = draw_sign({arrow, "0.42 m", "forward, 0.20 m/s"});
    EXPECT_EQ(frame.width, 640);
    EXPECT_EQ(frame.height, 480);
    pictures.emplace(frame.bytes.begin(), frame.bytes.end());
  }
  EXPECT_EQ(pictures.size(), std::size(kArrows));
}

TEST(Sign, LeftIsLeftAndRightIsRight) {
  for (const auto& [left, right] : {std::pair{Arrow::CurveLeft, Arrow::CurveRight},
                                    {Arrow::BackLeft, Arrow::BackRight},
                                    {Arrow::TurnLeft, Arrow::TurnRight}}) {
    const auto a = ink(draw_sign({left, "", ""}));
    const auto b = ink(draw_sign({right, "", ""}));
    EXPECT_GT(a.first, a.second);
    EXPECT_GT(b.second, b.first);
  }
}

TEST(Sign, WordsStayOnTheSheet) {
  const Frame frame =
      draw_sign({Arrow::CurveLeft, "0.50 m, 45 deg", "backward, to the right, 0.20 m/s"});
  for (int y = 0; y < frame.height; ++y) {
    const auto row = frame.row(y);
    EXPECT_EQ(row.front(), 255) << y;
    EXPECT_EQ(row.back(), 255) << y;
  }
}

}  // namespace
}  // namespace eyebridge::camera::testing
