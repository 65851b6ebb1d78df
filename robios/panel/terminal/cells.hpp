#pragma once

#include <vector>

#include "eyebridge/base/colour.hpp"

namespace eyebridge::robios {

/// The lower half of its cell shows the paper, the upper half the ink.
inline constexpr char32_t kUpperHalf = U'▀';

/// What one character cell of a terminal shows.
struct ScreenCell {
  char32_t glyph = U' ';
  Rgb ink;  ///< Black where nothing is drawn with it, so that equal looks are equal cells.
  Rgb paper;

  friend bool operator==(const ScreenCell&, const ScreenCell&) = default;
};

/// A rectangle of cells.
struct CellGrid {
  int columns = 0;
  int rows = 0;
  std::vector<ScreenCell> cells;  ///< Row by row.

  CellGrid() = default;
  CellGrid(int width, int height)
      : columns(width),
        rows(height),
        cells(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}
  [[nodiscard]] ScreenCell& at(int column, int row) {
    return cells.at(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(column));
  }
  [[nodiscard]] const ScreenCell& at(int column, int row) const {
    return cells.at(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(column));
  }

  friend bool operator==(const CellGrid&, const CellGrid&) = default;
};

}  // namespace eyebridge::robios
