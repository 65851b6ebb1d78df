#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "lcd_test_support.hpp"
#include "terminal/colours.hpp"
#include "terminal/lcd_view.hpp"

namespace eyebridge::robios {
namespace {

constexpr int kLcdColumns = 80;
constexpr int kAllRows = 27;  // 400 pixels in rows of 15, the last one not whole

CellGrid shown(const Lcd& lcd, int columns = 100, int rows = 40) {
  const ScreenShot shot = lcd.shot();
  return cells_of(shot, view_of(shot, columns, rows));
}

std::string text_of(const CellGrid& grid, int row) {
  std::string text;
  for (int column = 0; column < grid.columns; ++column) {
    const char32_t glyph = grid.at(column, row).glyph;
    text += glyph < 256 ? static_cast<char>(glyph) : '#';
  }
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

TEST(LcdView, ShowsAllOfTheLcdInTheLowestRowsOfAWindow) {
  const LcdView view = view_of(Lcd().shot(), 100, 40);
  EXPECT_EQ(view.columns, kLcdColumns);
  EXPECT_EQ(view.rows, kAllRows);
  EXPECT_EQ(view.top, 40 - kAllRows);
  EXPECT_EQ(view.strip, 0);
}

TEST(LcdView, LeavesRoomForTheProgramsOutput) {
  for (int rows = 4; rows < 60; ++rows) {
    const LcdView view = view_of(Lcd().shot(), 80, rows);
    EXPECT_GE(view.top, std::min(3, std::max(1, rows / 8))) << rows;
    EXPECT_EQ(view.top + view.rows, rows);
    EXPECT_GT(view.rows, 0);
  }
}

TEST(LcdView, IsNothingInATinyWindow) {
  EXPECT_EQ(view_of(Lcd().shot(), 80, 3).rows, 0);
  EXPECT_EQ(view_of(Lcd().shot(), 10, 24).rows, 0);
  EXPECT_EQ(cells_of(Lcd().shot(), view_of(Lcd().shot(), 10, 3)).cells.size(), 0U);
}

TEST(LcdView, FollowsTheTextCursorWhereTheLcdDoesNotFit) {
  Lcd lcd;
  lcd.set_menu({"A", "B", "C", "D"});
  lcd.print_at(0, 0, "first");
  LcdView view = view_of(lcd.shot(), 80, 24);
  EXPECT_EQ(view.first_row, 0);
  EXPECT_EQ(view.strip, 1);
  lcd.print_at(23, 0, "last");
  view = view_of(lcd.shot(), 80, 24);
  EXPECT_EQ(view.first_row, 24 - (view.rows - 1));
  EXPECT_EQ(text_of(cells_of(lcd.shot(), view), view.rows - 2), "last");
}

TEST(LcdCells, ShowTextAsTextInItsColours) {
  Lcd lcd;
  lcd.set_text_colours({200, 100, 0}, {0, 0, 100});
  lcd.print_at(2, 5, "Wei\xC3\x9F |");
  const CellGrid grid = shown(lcd);
  EXPECT_EQ(grid.at(5, 2), (ScreenCell{U'W', {200, 100, 0}, {0, 0, 100}}));
  EXPECT_EQ(grid.at(8, 2).glyph, U'\u00DF');
  EXPECT_EQ(grid.at(9, 2), (ScreenCell{U' ', {}, {0, 0, 100}}));
  EXPECT_EQ(grid.at(11, 2), (ScreenCell{}));
}

TEST(LcdCells, ShowEveryCharacterInEveryFont) {
  for (int font = 0; font < 3; ++font) {
    for (const int size : font_sizes()) {
      Lcd lcd;
      ASSERT_TRUE(lcd.set_font(font, font));
      ASSERT_TRUE(lcd.set_font_size(size));
      lcd.print("!09AZaz~ \xE9");
      EXPECT_EQ(text_of(shown(lcd, 200, 60), 0), "!09AZaz~ \xE9") << font << ' ' << size;
    }
  }
}

TEST(LcdCells, ShowTextThatALineCrossesButNotTextThatIsCovered) {
  Lcd lcd;
  lcd.print_at(0, 0, "crossed");
  lcd.line(0, 7, 200, 7, {0, 90, 0});
  EXPECT_EQ(text_of(shown(lcd), 0).substr(0, 7), "crossed");
  lcd.area(0, 0, 200, 20, {}, true);
  EXPECT_EQ(text_of(shown(lcd), 0), "");
  lcd.print_at(0, 0, "again");
  EXPECT_EQ(text_of(shown(lcd), 0), "again");
}

TEST(LcdCells, ShowTextOfAnotherSizeAsGraphics) {
  Lcd lcd;
  lcd.print_at(0, 0, "small");
  ASSERT_TRUE(lcd.set_font_size(24));
  lcd.print_at(1, 0, "large");
  const CellGrid grid = shown(lcd);
  EXPECT_EQ(grid.columns, 40);
  EXPECT_EQ(text_of(grid, 0).find("small"), std::string::npos);
  EXPECT_NE(grid.at(0, 0), ScreenCell{}) << "but it is to be seen";
  EXPECT_EQ(text_of(grid, 1), "large");
}

/// Each half of a cell against the pixels themselves.
TEST(LcdCells, ShowAreasAndPicturesAsHalfBlocks) {
  Lcd lcd;
  std::vector<std::uint8_t> gradient(320 * 240 * 3);
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    gradient[i] = static_cast<std::uint8_t>(i % 960 / 4 + i / 9600 + 10 * (i % 3));
  }
  lcd.image(gradient.data());
  const CellGrid grid = shown(lcd);
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 45; ++column) {
      const ScreenCell& cell = grid.at(column, row);
      for (const bool lower : {false, true}) {
        double sum = 0;
        const int top = row * 15 + (lower ? 7 : 0);
        const int height = lower ? 8 : 7;
        for (int y = top; y < top + height; ++y) {
          for (int x = column * 7; x < column * 7 + 7; ++x) sum += lcd.pixel_at(x, y).value().g;
        }
        const Rgb colour = lower || cell.glyph == U' ' ? cell.paper : cell.ink;
        ASSERT_NEAR(colour.g, sum / (7 * height), 0.51) << column << ' ' << row << ' ' << lower;
      }
    }
  }
}

TEST(LcdCells, LetThinLinesBeSeen) {
  Lcd lcd;
  lcd.line(0, 100, 559, 100, kRed);
  lcd.line(300, 0, 300, 360, kGreen);
  const CellGrid grid = shown(lcd);
  EXPECT_GE(grid.at(10, 6).paper.r + grid.at(10, 6).ink.r, 127);
  EXPECT_GE(grid.at(42, 3).paper.g, 127);
  EXPECT_EQ(grid.at(10, 8), ScreenCell{});
}

TEST(LcdCells, ShowSoftKeysInTheirColours) {
  Lcd lcd;
  lcd.set_menu({"GO", "two\nlines", "", "END"});
  CellGrid grid = shown(lcd);
  EXPECT_EQ(text_of(grid, 24).find("two"), 28U);
  EXPECT_EQ(text_of(grid, 25).find("GO"), 9U);
  EXPECT_EQ(text_of(grid, 25).find("lines"), 27U);
  EXPECT_EQ(grid.at(0, 24).paper, kRed);
  EXPECT_EQ(grid.at(79, 26).paper, (Rgb{0, 0, 255}));
  grid = shown(lcd, 40, 10);
  EXPECT_EQ(text_of(grid, grid.rows - 1).substr(10, 10),
            "two lines "
            "")
      << "in one row";
}

TEST(LcdCells, BelieveTheTextOfScreensWithOtherFonts) {
  ScreenShot shot = Lcd().shot();
  shot.cell_width = 8;
  shot.cell_height = 8;
  shot.font_size = 0;
  shot.text.front() = {'M', {}, {}, true, kRed, kBlack};
  const LcdView view = view_of(shot, 100, 60);
  EXPECT_EQ(view.columns, 70);
  EXPECT_EQ(cells_of(shot, view).at(0, 0), (ScreenCell{U'M', kRed, kBlack}));
}

TEST(LcdCells, ShowWhatIsRefreshedOnly) {
  Lcd lcd;
  lcd.print("old");
  lcd.set_mode(0x0100);  // LCD_NOAUTOREFRESH
  lcd.print_at(0, 0, "new");
  EXPECT_EQ(text_of(shown(lcd), 0), "old");
  lcd.refresh();
  EXPECT_EQ(text_of(shown(lcd), 0), "new");
}

TEST(LcdTouch, IsThePixelUnderTheCharacter) {
  Lcd lcd;
  const LcdView view = view_of(lcd.shot(), 100, 40);
  EXPECT_EQ(pixel_under(view, 0, view.top), (TouchPoint{3, 7}));
  EXPECT_EQ(pixel_under(view, 79, view.top + 26), (TouchPoint{556, 397}));
  EXPECT_EQ(pixel_under(view, 80, view.top), std::nullopt);
  EXPECT_EQ(pixel_under(view, 0, view.top - 1), std::nullopt);
  EXPECT_EQ(pixel_under(view, 0, 40), std::nullopt);
}

TEST(LcdTouch, OnALabelIsItsKeyInEveryWindow) {
  Lcd lcd;
  lcd.set_menu({"A", "B", "C", "D"});
  const std::array<Rgb, 4> papers = {kRed, kGreen, Rgb{255, 255, 0}, Rgb{0, 0, 255}};
  for (int columns = 16; columns < 100; ++columns) {
    const ScreenShot shot = lcd.shot();
    const LcdView view = view_of(shot, columns, columns % 2 == 0 ? 24 : 50);
    const CellGrid grid = cells_of(shot, view);
    for (int column = 0; column < view.columns; ++column) {
      const int row = view.rows - 1;
      const auto pixel = pixel_under(view, column, view.top + row);
      ASSERT_TRUE(pixel);
      const int key = lcd.key_at(pixel->x, pixel->y);
      ASSERT_NE(key, 0);
      EXPECT_EQ(grid.at(column, row).paper, papers.at(static_cast<std::size_t>(std::log2(key))));
    }
  }
}

TEST(TerminalColours, AreTheNearestOfThePalette) {
  EXPECT_EQ(palette_index({0, 0, 0}), 16);
  EXPECT_EQ(palette_index({255, 255, 255}), 231);
  EXPECT_EQ(palette_index({255, 0, 0}), 196);
  EXPECT_EQ(palette_index({95, 135, 175}), 67);
  EXPECT_EQ(palette_index({128, 128, 128}), 244);
  EXPECT_EQ(palette_index({8, 8, 8}), 232);
  EXPECT_EQ(palette_index({238, 238, 238}), 255);
}

TEST(TerminalColours, AreAsTheTerminalSays) {
  EXPECT_EQ(colour_depth("xterm-256color", "truecolor"), ColourDepth::True);
  EXPECT_EQ(colour_depth("screen", "24bit"), ColourDepth::True);
  EXPECT_EQ(colour_depth("xterm-direct", ""), ColourDepth::True);
  EXPECT_EQ(colour_depth("xterm-256color", ""), ColourDepth::Palette256);
  EXPECT_EQ(colour_depth("", "yes"), ColourDepth::Palette256);
}

}  // namespace
}  // namespace eyebridge::robios
