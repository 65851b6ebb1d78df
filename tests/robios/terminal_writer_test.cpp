#include <array>
#include <random>

#include <gtest/gtest.h>

#include "terminal/cell_writer.hpp"
#include "terminal_expect.hpp"

namespace eyebridge::robios {
namespace {

using testing::TerminalEmulator;

constexpr std::array<Rgb, 3> kColours = {Rgb{}, Rgb{255, 255, 255}, Rgb{17, 200, 90}};
constexpr std::array<char32_t, 4> kGlyphs = {U' ', U'x', U'\u00E9', kUpperHalf};

TEST(CellWriter, MakesEachGridOutOfTheOneBefore) {
  std::mt19937 random(11);
  for (const ColourDepth depth : {ColourDepth::True, ColourDepth::Palette256}) {
    TerminalEmulator terminal(24, 12);
    CellGrid before;
    CellGrid grid(20, 6);
    for (int i = 0; i < 200; ++i) {
      for (int n = 0; n < 12; ++n) {
        ScreenCell& cell = grid.cells.at(random() % grid.cells.size());
        cell = {kGlyphs.at(random() % 4), kColours.at(random() % 3), kColours.at(random() % 3)};
        if (cell.glyph == U' ') cell.ink = {};
      }
      terminal.feed(changed_cells(before, grid, 5, depth));
      expect_shown(terminal, grid, 5, depth);
      before = grid;
    }
    EXPECT_TRUE(terminal.history().empty());
  }
}

TEST(CellWriter, SendsNothingWhenNothingHasChanged) {
  const CellGrid grid(80, 27);
  EXPECT_EQ(changed_cells(grid, grid, 0, ColourDepth::True), "");
  CellGrid darker = grid;
  darker.at(3, 3).paper = {3, 3, 3};
  EXPECT_EQ(changed_cells(grid, darker, 0, ColourDepth::Palette256), "") << "nobody would see it";
  EXPECT_NE(changed_cells(grid, darker, 0, ColourDepth::True), "");
}

TEST(CellWriter, SendsLittle) {
  CellGrid grid(80, 27);
  EXPECT_LT(changed_cells({}, grid, 0, ColourDepth::True).size(), 27 * (80 + 9));
  const CellGrid before = grid;
  for (int i = 0; i < 4; ++i) {
    grid.at(10 + i, 4) = {U'0', {255, 255, 255}, {}};
  }
  EXPECT_LT(changed_cells(before, grid, 0, ColourDepth::True).size(), 60U);
  EXPECT_LT(changed_cells(before, grid, 0, ColourDepth::Palette256).size(), 40U);
}

}  // namespace
}  // namespace eyebridge::robios
