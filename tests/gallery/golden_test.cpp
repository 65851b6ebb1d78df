// Goldens that do not notice are worth nothing.

#include "golden.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lcd_cells.hpp"
#include "trail.hpp"

namespace eyebridge::gallery {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Golden one(const std::string& name, const Lines& lines) { return {"seen", {{name, lines}}}; }

TEST(Golden, IsReadAsItWasWritten) {
  const Golden golden{"the robot waits", {{"stdout", {"a", "", " b "}}, {"trail", {"1 2"}}}};
  const Golden again = parse_golden(to_text(golden));
  EXPECT_EQ(again.review, golden.review);
  EXPECT_EQ(again.sections, golden.sections);
}

TEST(Golden, KnowsThatNobodyHasLooked) { EXPECT_EQ(parse_golden(to_text({"", {}})).review, ""); }

TEST(Golden, RefusesWhatIsNone) {
  EXPECT_THROW(parse_golden("# review: x\nhello\n"), std::runtime_error);
}

TEST(Golden, NoticesALineThatIsOther) {
  EXPECT_THAT(differences(one("stdout", {"a", "b"}), one("stdout", {"a", "c"}), {}),
              ElementsAre(HasSubstr("line 2")));
  EXPECT_THAT(differences(one("stdout", {"a"}), one("stdout", {"a", "b"}), {}), SizeIs(1));
  EXPECT_THAT(differences(one("stdout", {"a"}), one("stdout", {"a"}), {}), IsEmpty());
}

TEST(Golden, NoticesASectionTooManyOrTooFew) {
  EXPECT_THAT(differences(one("files", {"a"}), {"", {}}, {}), SizeIs(1));
  EXPECT_THAT(differences({"", {}}, one("files", {"a"}), {}), SizeIs(1));
}

TEST(Golden, NumbersMayDifferByTheirToleranceOnly) {
  const Golden golden = one("trail", {"end 100 -5 mm"});
  EXPECT_THAT(differences(golden, one("trail", {"end  99 4 mm"}), {10, 0}), IsEmpty());
  EXPECT_THAT(differences(golden, one("trail", {"end 99 6 mm"}), {10, 0}), SizeIs(1));
  EXPECT_THAT(differences(golden, one("trail", {"end 100 -5 cm"}), {10, 0}), SizeIs(1));
  EXPECT_THAT(differences(golden, one("trail", {"end 100"}), {10, 0}), SizeIs(1));
}

TEST(Golden, WhatIsPrintedIsExact) {
  EXPECT_THAT(differences(one("stdout", {"1"}), one("stdout", {"2"}), {10, 0}), SizeIs(1));
}

TEST(Golden, TheExitCodeIsExactAndTheTimeIsNot) {
  const Golden golden = one("end", {"exit code 0 after 2.00 s"});
  EXPECT_THAT(differences(golden, one("end", {"exit code 0 after 2.50 s"}), {1, 0}), IsEmpty());
  EXPECT_THAT(differences(golden, one("end", {"exit code 0 after 3.50 s"}), {1, 0}), SizeIs(1));
  EXPECT_THAT(differences(golden, one("end", {"exit code 1 after 2.00 s"}), {1, 0}), SizeIs(1));
  EXPECT_THAT(differences(one("end", {"exit code 0"}), one("end", {"exit code 1"}), {1, 0}),
              SizeIs(1));
}

TEST(Golden, TheHashOfAPictureIsExact) {
  EXPECT_THAT(differences(one("lcd picture", {"8 x 8, pixels 122c"}),
                          one("lcd picture", {"8 x 8, pixels 123c"}), {10, 0}),
              SizeIs(1));
}

TEST(Golden, TheSizeOfAPictureOfTheCameraIsExact) {
  EXPECT_THAT(differences(one("lcd picture", {"80 x 16", ".........."}),
                          one("lcd picture", {"80 x 15", ".........."}), {10, 0.5}),
              SizeIs(1));
}

TEST(Golden, APictureOfTheCameraMayDifferInFewCells) {
  const Golden golden = one("lcd picture", {"..........", ".........."});
  EXPECT_THAT(differences(golden, one("lcd picture", {"..........", ".........W"}), {0, 0.05}),
              IsEmpty());
  EXPECT_THAT(differences(golden, one("lcd picture", {"..........", "........WW"}), {0, 0.05}),
              SizeIs(1));
}

camera::Frame black(int width, int height) {
  camera::Frame frame;
  frame.width = width;
  frame.height = height;
  frame.stride = 3 * width;
  frame.bytes.resize(static_cast<std::size_t>(3 * width * height));
  return frame;
}

void paint_green(camera::Frame& lcd, std::size_t left, std::size_t right, std::size_t bottom) {
  const auto width = static_cast<std::size_t>(lcd.width);
  for (std::size_t y = 0; y < bottom; ++y) {
    for (std::size_t x = left; x < right; ++x) lcd.bytes[3 * (width * y + x) + 1] = 250;
  }
}

TEST(LcdCells, SayWhichColourCoversACell) {
  camera::Frame lcd = black(168, 20);
  lcd.bytes[3 * 8] = 255;  // one red pixel in the second cell
  paint_green(lcd, 16, 24, 16);
  const std::string nothing(18, '.');
  EXPECT_THAT(lcd_cells(lcd),
              ElementsAre(".rG" + nothing, "..." + nothing, ". black  R red  G green"));
}

TEST(LcdCells, OfASmallScreenAreSmall) {
  camera::Frame lcd = black(8, 8);
  paint_green(lcd, 2, 8, 8);  // more than is left of the black
  EXPECT_THAT(lcd_cells(lcd), ElementsAre("K...", "K...", ". green  K black"));
}

TEST(LcdCells, TheHashNoticesOnePixel) {
  camera::Frame lcd = black(8, 8);
  const std::string before = hash_of(lcd);
  lcd.bytes.back() = 1;
  EXPECT_NE(hash_of(lcd), before);
}

TEST(Trail, TellsEndWayAndPoses) {
  const std::string csv = "t,x,y,theta\n0.000,0,0,0,\n0.050,0.3,0,0,\n0.100,0.3,0.4,1.5707963,\n";
  EXPECT_EQ(trail_lines(csv, true), Lines{"end 300 400 mm 90 deg, path 700 mm"});
  EXPECT_THAT(trail_lines(csv, false), SizeIs(5));
  EXPECT_THAT(trail_lines("", false), ElementsAre(HasSubstr("no trail")));
}

}  // namespace
}  // namespace eyebridge::gallery
