#include <climits>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"
#include "lcd.hpp"
#include "lcd_test_support.hpp"

namespace eyebridge::robios {
namespace {

constexpr int kRows = 24;
constexpr int kColumns = 80;

TEST(LcdText, StartsBlackWithTheCursorAtHome) {
  const Lcd lcd;
  EXPECT_EQ(lcd.position(), (TextPosition{0, 0}));
  EXPECT_EQ(lcd.pixel_at(0, 0).value(), kBlack);
  EXPECT_THAT(lcd.text_rows(), testing::AllOf(testing::SizeIs(kRows), testing::Each("")));
}

TEST(LcdText, DrawsEachCharacterInItsCell) {
  Lcd lcd;
  lcd.set_text_colours({200, 100, 0}, {0, 0, 100});
  lcd.print_at(2, 5, "A");
  const Font font(FontFamily::Helvetica, FontStyle::Normal, 12);
  const auto glyph = font.glyph('A');
  const int left = 5 * font.cell_width();
  const int top = 2 * font.cell_height();
  for (int y = 0; y < font.cell_height(); ++y) {
    for (int x = 0; x < font.cell_width(); ++x) {
      const double ink = glyph[static_cast<std::size_t>(y * font.cell_width() + x)] / 255.0;
      const Rgb pixel = lcd.pixel_at(left + x, top + y).value();
      EXPECT_NEAR(pixel.r, 200 * ink, 1);
      EXPECT_NEAR(pixel.g, 100 * ink, 1);
      EXPECT_NEAR(pixel.b, 100 * (1 - ink), 1);
    }
  }
  EXPECT_EQ(lcd.pixel_at(left - 1, top).value(), kBlack);
  EXPECT_EQ(lcd.pixel_at(left + font.cell_width(), top).value(), kBlack);
  EXPECT_EQ(lcd.position(), (TextPosition{2, 6}));
}

TEST(LcdText, OverwritesWhatWasThere) {
  Lcd lcd;
  lcd.print("8888");
  lcd.print_at(0, 0, "    ");
  EXPECT_EQ(lcd.snapshot().bytes, Lcd().snapshot().bytes);
  EXPECT_EQ(lcd.text_rows()[0], "");
}

TEST(LcdText, KnowsTheUsualControlCharacters) {
  Lcd lcd;
  lcd.print("ab\ncd\te\rX\bY\x07");
  EXPECT_EQ(lcd.text_rows()[0], "ab");
  EXPECT_EQ(lcd.text_rows()[1], "Yd      e");
  EXPECT_EQ(lcd.position(), (TextPosition{1, 1}));
}

TEST(LcdText, ContinuesAFullRowInTheNext) {
  Lcd lcd;
  lcd.print(std::string(kColumns, 'x') + "\ny");
  EXPECT_EQ(lcd.text_rows()[1], "y");  // the full row alone does not begin another one
  lcd.print(std::string(kColumns, 'z'));
  EXPECT_EQ(lcd.text_rows()[1], "y" + std::string(kColumns - 1, 'z'));
  EXPECT_EQ(lcd.text_rows()[2], "z");
}

TEST(LcdText, CutsOffAFullRowWithoutLineFeed) {
  Lcd lcd;
  lcd.set_mode(0x0400);
  lcd.print(std::string(kColumns + 5, 'x') + "\ny");
  EXPECT_EQ(lcd.text_rows()[0].size(), static_cast<std::size_t>(kColumns));
  EXPECT_EQ(lcd.text_rows()[1], "y");
}

TEST(LcdText, ScrollsOnlyWhenMoreTextComes) {
  Lcd lcd;
  for (int i = 0; i < kRows; ++i) {
    lcd.print(std::to_string(i) + "\n");
  }
  EXPECT_EQ(lcd.text_rows()[0], "0");
  lcd.print("more");
  EXPECT_EQ(lcd.text_rows()[0], "1");
  EXPECT_EQ(lcd.text_rows()[kRows - 1], "more");
  EXPECT_EQ(lcd.position(), (TextPosition{kRows - 1, 4}));
}

TEST(LcdText, ScrollingMovesThePicture) {
  Lcd scrolled;
  scrolled.print("first\n");
  for (int i = 1; i < kRows; ++i) {
    scrolled.print("same\n");
  }
  scrolled.print("last");
  Lcd expected;
  for (int i = 1; i < kRows; ++i) {
    expected.print("same\n");
  }
  expected.print("last");
  EXPECT_EQ(scrolled.snapshot().bytes, expected.snapshot().bytes);
}

TEST(LcdText, StaysWithoutScrolling) {
  Lcd lcd;
  lcd.set_mode(0x0200);
  lcd.print("top");
  lcd.print(std::string(100, '\n') + "below");
  EXPECT_EQ(lcd.text_rows()[0], "top");
  EXPECT_THAT(lcd.text_rows(), testing::Each(testing::Not("below")));
}

TEST(LcdText, PlacedOutsideIsCutOffAndNeverScrolls) {
  Lcd lcd;
  lcd.print("stays");
  for (const int row : {INT_MIN, -1, kRows, INT_MAX}) {
    lcd.print_at(row, 0, "gone\n\n");
  }
  lcd.print_at(3, INT_MAX, "gone");
  lcd.print_at(3, INT_MIN, "gone");
  lcd.print_at(4, -2, "cut");
  EXPECT_EQ(lcd.text_rows()[0], "stays");
  EXPECT_EQ(lcd.text_rows()[3], "");
  EXPECT_EQ(lcd.text_rows()[4], "t");
}

TEST(LcdText, ManyNewLinesAtOnceScrollEverythingAway) {
  Lcd lcd;
  lcd.print("gone" + std::string(5000, '\n') + "here");
  EXPECT_EQ(lcd.text_rows()[0], "");
  EXPECT_EQ(lcd.text_rows()[kRows - 1], "here");
}

TEST(LcdText, ClearForgetsTextColoursAndPlace) {
  Lcd lcd;
  lcd.set_text_colours(kRed, kGreen);
  lcd.print("x");
  lcd.clear();
  EXPECT_EQ(lcd.snapshot().bytes, Lcd().snapshot().bytes);
  lcd.print("x");
  Lcd fresh;
  fresh.print("x");
  EXPECT_EQ(lcd.snapshot().bytes, fresh.snapshot().bytes);
}

TEST(LcdText, LargerFontsHaveFewerAndLargerCells) {
  Lcd lcd;
  ASSERT_TRUE(lcd.set_font_size(24));
  EXPECT_EQ(lcd.text_rows().size(), 12u);  // 362 pixels above the strip, 30 a row
  lcd.print_at(1, 1, "M");
  EXPECT_EQ(lcd.text_rows()[1], " M");
  ASSERT_TRUE(lcd.set_font_size(8));
  EXPECT_EQ(lcd.text_rows().size(), 36u);
}

TEST(LcdText, RefusesFontsThatThereAreNot) {
  Lcd lcd;
  EXPECT_EQ(lcd.set_font_size(13).error().what, "font size 13, expected 8, 10, 12, 14, 18 or 24");
  EXPECT_EQ(lcd.set_font(3, 0).error().code, Errc::OutOfRange);
  EXPECT_EQ(lcd.set_font(0, -1).error().code, Errc::OutOfRange);
  EXPECT_TRUE(lcd.set_font(2, 1));
}

TEST(LcdText, ShowsDegreesAndUmlauts) {
  Lcd lcd;
  lcd.print("30\xC2\xB0 \xC3\xA4");
  EXPECT_EQ(lcd.text_rows()[0], "30\xC2\xB0 \xC3\xA4");
  EXPECT_EQ(lcd.position().column, 5);
}

TEST(LcdText, ManyThreadsPrintWholeTexts) {
  Lcd lcd;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&lcd, i] {
      for (int k = 0; k < 50; ++k) {
        lcd.print_at(i, 0, "thread " + std::to_string(i));
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(lcd.text_rows()[i], "thread " + std::to_string(i));
  }
}

TEST(Lcd, RefusesSizesThatAreNoScreens) {
  EXPECT_THROW(Lcd(100, 400), ConfigError);
  EXPECT_THROW(Lcd(480, 5000), ConfigError);
  EXPECT_EQ(Lcd(320, 240).snapshot().width, 320);
}

}  // namespace
}  // namespace eyebridge::robios
