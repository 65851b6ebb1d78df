#include "terminal/lcd_view.hpp"

#include <algorithm>

namespace eyebridge::robios {
namespace {

// Windows with less have no room for a panel.
constexpr int kFewestColumns = 16;
constexpr int kFewestRows = 4;
constexpr int kMostOutputRows = 3;

int rounded_up(int amount, int unit) { return (amount + unit - 1) / unit; }

}  // namespace

LcdView view_of(const ScreenShot& shot, int columns, int rows) {
  LcdView view;
  view.cell_width = shot.cell_width;
  view.cell_height = shot.cell_height;
  view.lcd_width = shot.picture.width;
  view.lcd_height = shot.picture.height;
  if (columns < kFewestColumns || rows < kFewestRows) return view;

  const int all_rows = rounded_up(view.lcd_height, view.cell_height);
  const int output = std::clamp(rows / 8, 1, kMostOutputRows);
  view.columns = std::min(columns, rounded_up(view.lcd_width, view.cell_width));
  view.rows = std::min(all_rows, rows - output);
  view.top = rows - view.rows;
  if (shot.menu_shown) {
    const int below_text = std::max(all_rows - shot.text_rows, 1);
    view.strip = view.rows == all_rows ? below_text : 1;
  }
  const int shown = view.rows - view.strip;
  const int most = (shot.menu_shown ? shot.text_rows : all_rows) - shown;
  view.first_row = std::clamp(shot.cursor.row - shown + 1, 0, std::max(most, 0));
  return view;
}

std::optional<TouchPoint> pixel_under(const LcdView& view, int column, int row) {
  const int in_panel = row - view.top;
  if (column < 0 || column >= view.columns || in_panel < 0 || in_panel >= view.rows) {
    return std::nullopt;
  }
  if (in_panel >= view.rows - view.strip) {
    return TouchPoint{(2 * column + 1) * view.lcd_width / (2 * view.columns),
                      view.lcd_height - view.cell_height / 2};
  }
  const auto middle = [](int cell, int size, int end) {
    return std::min(cell * size + size / 2, end - 1);
  };
  return TouchPoint{middle(column, view.cell_width, view.lcd_width),
                    middle(view.first_row + in_panel, view.cell_height, view.lcd_height)};
}

}  // namespace eyebridge::robios
