#include "mono_lcd.hpp"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eyebridge::robios {
namespace {

using ::testing::ElementsAre;
using Pen = MonoLcd::Pen;

int black_pixels(const MonoLcd& lcd, int x1, int y1, int x2, int y2) {
  int count = 0;
  for (int y = y1; y <= y2; ++y) {
    for (int x = x1; x <= x2; ++x) count += lcd.pixel_at(x, y).value() ? 1 : 0;
  }
  return count;
}

TEST(MonoLcd, AFullRowGoesOnInTheNextAndALineEndAfterItAddsNone) {
  MonoLcd lcd;
  lcd.print("0123456789abcdef\nnext");
  EXPECT_THAT(lcd.text_rows(), ElementsAre("0123456789abcdef", "next", "", "", "", "", "", ""));
  lcd.print(" and much more text");
  EXPECT_EQ(lcd.text_rows().at(1), "next and much mo");
  EXPECT_EQ(lcd.text_rows().at(2), "re text");
  EXPECT_EQ(lcd.position(), (TextPosition{2, 7}));
}

TEST(MonoLcd, ScrollsWhenThereIsTextForARowBelowTheLast) {
  MonoLcd lcd;
  lcd.set_label(0, "GO");
  for (int i = 0; i < 7; ++i) lcd.print(std::to_string(i) + "\n");
  EXPECT_THAT(lcd.text_rows(), ElementsAre("0", "1", "2", "3", "4", "5", "6", "GO"));
  lcd.print("7");
  EXPECT_THAT(lcd.text_rows(), ElementsAre("1", "2", "3", "4", "5", "6", "7", "GO"));
}

TEST(MonoLcd, WithoutScrollingTextGoesOnAtTheTop) {
  MonoLcd lcd;
  lcd.set_mode(false, false);
  for (int i = 0; i < 7; ++i) lcd.print(std::to_string(i) + "\n");
  lcd.print("7");
  EXPECT_EQ(lcd.text_rows().at(0), "7");
  EXPECT_EQ(lcd.text_rows().at(1), "1");
}

TEST(MonoLcd, LabelsAreCutPaddedOrLeft) {
  MonoLcd lcd;
  lcd.set_label(0, "LONGER");
  lcd.set_label(3, "END");
  lcd.set_label(3, "");
  EXPECT_THAT(lcd.menu_labels(), ElementsAre("LONG", "", "", "END"));
  lcd.set_label(0, " ");
  EXPECT_THAT(lcd.menu_labels(), ElementsAre("", "", "", "END"));
  lcd.clear();
  EXPECT_THAT(lcd.menu_labels(), ElementsAre("", "", "", ""));
  EXPECT_EQ(lcd.key_at(0, 63), 1);
  EXPECT_EQ(lcd.key_at(127, 56), 8);
  EXPECT_EQ(lcd.key_at(127, 55), 0);
}

TEST(MonoLcd, PlacesOutsideAreErrors) {
  MonoLcd lcd;
  EXPECT_TRUE(lcd.set_position(6, 15));
  EXPECT_FALSE(lcd.set_position(7, 0));
  EXPECT_FALSE(lcd.set_position(0, 16));
  EXPECT_FALSE(lcd.print_at(-1, 0, "x"));
  EXPECT_FALSE(lcd.pixel(128, 0, Pen::Set));
  EXPECT_FALSE(lcd.pixel_at(0, 64));
}

TEST(MonoLcd, PensClearSetAndInvert) {
  MonoLcd lcd;
  lcd.area(10, 10, 19, 14, Pen::Set);
  EXPECT_EQ(black_pixels(lcd, 0, 0, 127, 63), 50);
  lcd.area(10, 10, 14, 14, Pen::Invert);
  EXPECT_EQ(black_pixels(lcd, 0, 0, 127, 63), 25);
  lcd.line(0, 12, 127, 12, Pen::Invert);
  EXPECT_EQ(black_pixels(lcd, 0, 12, 127, 12), 123);
  lcd.line(0, 12, 127, 12, Pen::Clear);
  EXPECT_EQ(black_pixels(lcd, 0, 12, 127, 12), 0);
  EXPECT_TRUE(lcd.pixel(3, 3, Pen::Invert));
  EXPECT_TRUE(lcd.pixel_at(3, 3).value());
}

TEST(MonoLcd, APictureIsDitheredAndLeavesTheLabels) {
  MonoLcd lcd;
  lcd.set_label(0, "GO");
  const int label = black_pixels(lcd, 0, 56, 127, 63);
  const std::vector<std::uint8_t> grey(80 * 80, 128);
  lcd.picture(0, 0, 80, 80, grey.data(), 80);
  EXPECT_EQ(black_pixels(lcd, 0, 0, 79, 55), 80 * 56 / 2);  // two of four thresholds are above 128
  EXPECT_EQ(black_pixels(lcd, 0, 56, 127, 63), label);
  EXPECT_TRUE(is_white(0, 0, 52));
  EXPECT_FALSE(is_white(0, 0, 51));
  EXPECT_TRUE(is_white(-1, -1, 255));
  EXPECT_FALSE(is_white(5, 7, 0));
}

TEST(MonoLcd, ABitmapHasItsHighestBitLeft) {
  MonoLcd lcd;
  std::array<std::uint8_t, 1024> bits{};
  bits[0] = 0x80;
  bits[1023] = 0x01;
  lcd.bitmap(bits.data());
  EXPECT_TRUE(lcd.pixel_at(0, 0).value());
  EXPECT_TRUE(lcd.pixel_at(127, 63).value());
  EXPECT_EQ(black_pixels(lcd, 0, 0, 127, 63), 2);
}

TEST(MonoLcd, ThePictureShowsTheCursorOnlyWhenItShall) {
  MonoLcd lcd;
  const auto before = lcd.snapshot();
  EXPECT_EQ(before.width, 128);
  EXPECT_EQ(before.height, 64);
  lcd.set_mode(true, true);
  EXPECT_NE(lcd.snapshot().bytes, before.bytes);
  EXPECT_GT(lcd.revision(), before.sequence);
  lcd.set_mode(true, false);
  EXPECT_EQ(lcd.snapshot().bytes, before.bytes);
}

TEST(MonoLcd, EveryPrintableCharacterHasAPictureOfItsOwn) {
  std::vector<std::string> pictures;
  for (char c = '!'; c <= '~'; ++c) {
    MonoLcd lcd;
    lcd.print(std::string(1, c));
    std::string picture;
    for (int i = 0; i < 64; ++i) picture += lcd.pixel_at(i % 8, i / 8).value() ? '#' : '.';
    EXPECT_THAT(pictures, ::testing::Not(::testing::Contains(picture))) << c;
    pictures.push_back(picture);
  }
}

}  // namespace
}  // namespace eyebridge::robios
