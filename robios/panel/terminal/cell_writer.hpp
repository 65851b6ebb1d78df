#pragma once

#include <string>

#include "terminal/cells.hpp"
#include "terminal/colours.hpp"

namespace eyebridge::robios {

/// What has to be sent so that a terminal that shows `before` shows `after`: for each run of cells
/// that differ a cursor position, and colours where they change. `top` is the window's row (from 0)
/// of the grids' first row. Grids of different sizes: everything is sent. UTF-8 and ECMA-48; ""
/// when nothing differs. Attributes and cursor are left anywhere.
std::string changed_cells(const CellGrid& before, const CellGrid& after, int top,
                          ColourDepth depth);

}  // namespace eyebridge::robios
