#pragma once

#include <gtest/gtest.h>

#include "terminal/cells.hpp"
#include "terminal/colours.hpp"
#include "terminal_emulator.hpp"

namespace eyebridge::robios {

inline int seen_as(Rgb colour, ColourDepth depth) {
  return depth == ColourDepth::True ? colour.r << 16 | colour.g << 8 | colour.b
                                    : testing::TerminalEmulator::kPalette + palette_index(colour);
}

/// The rows of `terminal` from `top` on show `grid`, and nothing was sent that it does not know.
inline void expect_shown(const testing::TerminalEmulator& terminal, const CellGrid& grid, int top,
                         ColourDepth depth) {
  EXPECT_EQ(terminal.unknown(), "");
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const ScreenCell& cell = grid.at(column, row);
      const testing::TerminalEmulator::Cell& seen = terminal.at(column, top + row);
      ASSERT_EQ(seen.glyph, cell.glyph) << column << ' ' << row;
      ASSERT_EQ(seen.paper, seen_as(cell.paper, depth)) << column << ' ' << row;
      if (cell.glyph != U' ') {
        ASSERT_EQ(seen.ink, seen_as(cell.ink, depth)) << column << ' ' << row;
      }
    }
  }
}

}  // namespace eyebridge::robios
