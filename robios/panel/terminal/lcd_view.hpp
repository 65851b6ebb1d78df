#pragma once

#include <optional>

#include "key_script.hpp"
#include "lcd.hpp"
#include "terminal/cells.hpp"

namespace eyebridge::robios {

/// Where the LCD is seen in a window of a terminal, and where the program's own output goes.
///
/// One character of the terminal is one cell of the LCD's font, so that text is text: 80 x 27 for
/// the usual LCD, of which the last three rows are soft keys. The panel takes the lowest rows of
/// the window and leaves at least one, in taller windows three, above it. Where the LCD does not
/// fit it is cut off on the right, the soft keys shrink to one row, and of the rest those rows are
/// shown that have the text cursor, or else the topmost.
struct LcdView {
  int top = 0;         ///< Row of the window (from 0) in which the panel begins; 0: it has no room.
  int columns = 0;     ///< Of the panel.
  int rows = 0;        ///< Of the panel, the soft keys included.
  int strip = 0;       ///< Rows of soft keys among these, the last ones.
  int first_row = 0;   ///< Row of the LCD that is the panel's first one.
  int cell_width = 0;  ///< LCD pixels in a cell.
  int cell_height = 0;  ///< Likewise.
  int lcd_width = 0;    ///< Pixels.
  int lcd_height = 0;   ///< Pixels.

  friend bool operator==(const LcdView&, const LcdView&) = default;
};

/// The view of `shot` in a window of `columns` x `rows` characters.
LcdView view_of(const ScreenShot& shot, int columns, int rows);

/// The LCD pixel in the middle of the window's cell (from 0, 0), or nothing outside the panel. In
/// the rows of soft keys: a pixel of the key that is shown there.
std::optional<TouchPoint> pixel_under(const LcdView& view, int column, int row);

/// What the panel shows: view.columns x view.rows cells.
///
/// A character of which at least three quarters of the ink are still to be seen is that character.
/// Elsewhere each half of a cell is one colour: the mean of its pixels; but where one colour fills
/// most of a half and others less, as behind thin lines, the others count for at least half of it.
CellGrid cells_of(const ScreenShot& shot, const LcdView& view);

}  // namespace eyebridge::robios
