#include <array>
#include <climits>
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "lcd_test_support.hpp"

namespace eyebridge::robios {
namespace {

using Art = std::vector<std::string>;

/// Bresenham's line as it is taught: an error term, one pixel after the other, from the end with
/// the smaller coordinate on the longer axis.
void textbook_line(Canvas& canvas, int x1, int y1, int x2, int y2) {
  const bool steep = std::abs(y2 - y1) > std::abs(x2 - x1);
  if (steep) {
    std::swap(x1, y1);
    std::swap(x2, y2);
  }
  if (x1 > x2) {
    std::swap(x1, x2);
    std::swap(y1, y2);
  }
  const int dx = x2 - x1;
  const int dy = std::abs(y2 - y1);
  int error = dx / 2;
  for (int x = x1, y = y1; x <= x2; ++x) {
    const int px = steep ? y : x;
    const int py = steep ? x : y;
    if (canvas.contains(px, py)) {
      canvas.pixel(px, py, kWhite);
    }
    error += dy;
    if (error >= dx) {
      error -= dx;
      y += y2 < y1 ? -1 : 1;
    }
  }
}

TEST(CanvasLine, IsBresenhamsWhereverItIsCutOff) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> coordinate(-60, 100);
  for (int i = 0; i < 2000; ++i) {
    const int x1 = coordinate(random);
    const int y1 = coordinate(random);
    const int x2 = coordinate(random);
    const int y2 = coordinate(random);
    Canvas line(40, 30);
    Canvas expected(40, 30);
    line.line(x1, y1, x2, y2, kWhite);
    textbook_line(expected, x1, y1, x2, y2);
    ASSERT_EQ(art(line), art(expected)) << x1 << ' ' << y1 << ' ' << x2 << ' ' << y2;
  }
}

TEST(CanvasLine, ReachesFromOneEndOfTheNumbersToTheOther) {
  Canvas diagonal(5, 5);
  diagonal.line(INT_MIN, INT_MIN, INT_MAX, INT_MAX, kWhite);
  EXPECT_EQ(art(diagonal), (Art{"#....", ".#...", "..#..", "...#.", "....#"}));
  Canvas flat(5, 3);
  flat.line(INT_MAX, 1, INT_MIN, 1, kWhite);
  EXPECT_EQ(art(flat), (Art{".....", "#####", "....."}));
  Canvas upright(3, 3);
  upright.line(2, INT_MIN, 2, INT_MAX, kWhite);
  EXPECT_EQ(art(upright), (Art{"..#", "..#", "..#"}));
}

TEST(CanvasLine, OfOnePointIsAPixel) {
  Canvas canvas(3, 3);
  canvas.line(1, 1, 1, 1, kWhite);
  EXPECT_EQ(art(canvas), (Art{"...", ".#.", "..."}));
}

TEST(CanvasArea, IncludesBothCornersInAnyOrder) {
  Canvas filled(5, 4);
  filled.area(3, 2, 1, 1, kWhite, true);
  EXPECT_EQ(art(filled), (Art{".....", ".###.", ".###.", "....."}));
  Canvas frame(5, 5);
  frame.area(0, 0, 4, 3, kWhite, false);
  EXPECT_EQ(art(frame), (Art{"#####", "#...#", "#...#", "#####", "....."}));
}

TEST(CanvasArea, IsCutOffAtTheEdges) {
  Canvas filled(3, 3);
  filled.area(INT_MIN, INT_MIN, 1, 0, kWhite, true);
  EXPECT_EQ(art(filled), (Art{"##.", "...", "..."}));
  Canvas frame(3, 3);
  frame.area(1, 1, INT_MAX, INT_MAX, kWhite, false);
  EXPECT_EQ(art(frame), (Art{"...", ".##", ".#."}));
}

TEST(CanvasCircle, LooksRound) {
  Canvas point(3, 3);
  point.circle(1, 1, 0, kWhite, false);
  EXPECT_EQ(art(point), (Art{"...", ".#.", "..."}));
  Canvas small(7, 7);
  small.circle(3, 3, 2, kWhite, false);
  EXPECT_EQ(art(small),
            (Art{".......", "..###..", ".#...#.", ".#...#.", ".#...#.", "..###..", "......."}));
  Canvas larger(9, 9);
  larger.circle(4, 4, 4, kWhite, false);
  EXPECT_EQ(art(larger), (Art{"...###...", ".##...##.", ".#.....#.", "#.......#", "#.......#",
                              "#.......#", ".#.....#.", ".##...##.", "...###..."}));
}

TEST(CanvasCircle, RimAndDiscAgreeWithTheDistanceFromTheCentre) {
  for (const int radius : {1, 3, 8, 15}) {
    Canvas rim(41, 41);
    Canvas disc(41, 41);
    rim.circle(20, 20, radius, kWhite, false);
    disc.circle(20, 20, radius, kWhite, true);
    for (int y = 0; y < 41; ++y) {
      for (int x = 0; x < 41; ++x) {
        const int square = (x - 20) * (x - 20) + (y - 20) * (y - 20);
        const bool on_rim = rim.at(x, y) != kBlack;
        const bool in_disc = disc.at(x, y) != kBlack;
        EXPECT_EQ(on_rim, rim.at(y, x) != kBlack) << radius;
        if (on_rim) {
          EXPECT_LE(std::abs(square - radius * radius), radius + 1) << radius;
          EXPECT_TRUE(in_disc) << radius;
        }
        if (square <= radius * radius) {
          EXPECT_TRUE(in_disc) << radius;
        }
        if (square > radius * radius + radius + 1) {
          EXPECT_FALSE(in_disc) << radius;
        }
      }
    }
  }
}

TEST(CanvasCircle, MayBeAsLargeAsNumbersGo) {
  Canvas canvas(4, 3);
  canvas.circle(INT_MAX, 1, INT_MAX, kWhite, true);  // its rim passes x = 0
  EXPECT_EQ(art(canvas), (Art{"####", "####", "####"}));
  Canvas rim(4, 3);
  rim.circle(INT_MAX, 1, INT_MAX, kWhite, false);
  EXPECT_EQ(art(rim), (Art{"#...", "#...", "#..."}));
  Canvas away(4, 3);
  away.circle(INT_MIN, INT_MIN, INT_MAX, kWhite, true);
  EXPECT_EQ(art(away), (Art{"....", "....", "...."}));
}

TEST(CanvasPicture, ReadsOnlyWhatIsVisible) {
  const std::array<std::uint8_t, 6> grey{0, 50, 100, 150, 200, 250};  // 3 x 2
  const auto show = [&](int x, int y) {
    Canvas canvas(2, 2);
    canvas.picture(x, y, 3, 2, grey.data(), 1, [](const std::uint8_t* p) {
      return Rgb{*p, *p, *p};
    });
    std::vector<int> values;
    for (const Rgb pixel : canvas.pixels()) {
      values.push_back(pixel.r);
    }
    return values;
  };
  EXPECT_EQ(show(0, 0), (std::vector<int>{0, 50, 150, 200}));
  EXPECT_EQ(show(-1, -1), (std::vector<int>{200, 250, 0, 0}));
  EXPECT_EQ(show(1, 1), (std::vector<int>{0, 0, 0, 0}));
  EXPECT_EQ(show(INT_MIN, INT_MIN), (std::vector<int>{0, 0, 0, 0}));
  EXPECT_EQ(show(INT_MAX, INT_MAX), (std::vector<int>{0, 0, 0, 0}));
}

TEST(CanvasScroll, MovesRowsUpAndFillsTheGap) {
  Canvas canvas(2, 4);
  for (int y = 0; y < 4; ++y) {
    const auto shade = static_cast<std::uint8_t>(y + 1);
    canvas.line(0, y, 1, y, {shade, shade, shade});
  }
  canvas.scroll_up(1, 3, kRed);
  EXPECT_EQ(canvas.at(0, 0).r, 2);
  EXPECT_EQ(canvas.at(0, 1).r, 3);
  EXPECT_EQ(canvas.at(1, 2), kRed);
  EXPECT_EQ(canvas.at(1, 3).r, 4);
}

TEST(CanvasInvert, TurnsEveryColourIntoItsOppositeAndBack) {
  Canvas canvas(20, 10);
  canvas.area(0, 0, 19, 9, {10, 0, 255}, true);
  const std::vector<Rgb> before = canvas.pixels();
  canvas.invert_pixel(3, 4);
  EXPECT_EQ(canvas.at(3, 4), (Rgb{245, 255, 0}));
  canvas.invert_pixel(3, 4);
  canvas.invert_line(-50, -30, 100, 70);
  EXPECT_NE(canvas.pixels(), before);
  canvas.invert_line(-50, -30, 100, 70);
  canvas.invert_area(15, 8, 5, 2);
  EXPECT_EQ(canvas.at(5, 2), (Rgb{245, 255, 0}));
  EXPECT_EQ(canvas.at(15, 8), (Rgb{245, 255, 0}));
  EXPECT_EQ(canvas.at(4, 2), (Rgb{10, 0, 255}));
  canvas.invert_area(5, 2, 15, 8);
  canvas.invert_pixel(-1, 0);
  canvas.invert_area(INT_MIN, INT_MIN, -1, INT_MAX);
  EXPECT_EQ(canvas.pixels(), before);
}

}  // namespace
}  // namespace eyebridge::robios
