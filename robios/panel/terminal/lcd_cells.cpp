#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "terminal/lcd_view.hpp"
#include "utf8.hpp"

namespace eyebridge::robios {
namespace {

struct Box {
  int left = 0;
  int top = 0;
  int right = 0;   // outside
  int bottom = 0;  // outside
};

Rgb pixel_of(const camera::Frame& picture, int x, int y) {
  const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.stride) +
                  3 * static_cast<std::size_t>(x);
  return {picture.bytes[at], picture.bytes[at + 1], picture.bytes[at + 2]};
}

/// Sums of colours.
struct Sum {
  std::array<int, 3> channels{};
  int count = 0;

  void add(Rgb colour) {
    channels[0] += colour.r;
    channels[1] += colour.g;
    channels[2] += colour.b;
    ++count;
  }
  [[nodiscard]] Rgb mean() const {
    const auto of = [&](int sum) { return static_cast<std::uint8_t>((sum + count / 2) / count); };
    return {of(channels[0]), of(channels[1]), of(channels[2])};
  }
};

template <class Visit>
void each_pixel(const camera::Frame& picture, const Box& box, Visit visit) {
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) visit(pixel_of(picture, x, y));
  }
}

/// The only colour that can fill more than half of the box, found by the vote of Boyer and Moore.
Rgb candidate(const camera::Frame& picture, const Box& box) {
  Rgb found;
  int lead = 0;
  each_pixel(picture, box, [&](Rgb pixel) {
    if (lead == 0) found = pixel;
    lead += pixel == found ? 1 : -1;
  });
  return found;
}

/// The one colour in which a box is shown; black for an empty box.
Rgb colour_of(const camera::Frame& picture, const Box& box) {
  const Rgb ground = candidate(picture, box);
  Sum all;
  Sum others;
  each_pixel(picture, box, [&](Rgb pixel) {
    all.add(pixel);
    if (pixel != ground) others.add(pixel);
  });
  if (others.count == 0) return all.count == 0 ? Rgb{} : ground;
  if (2 * others.count >= all.count) return all.mean();
  Sum half;
  half.add(ground);
  half.add(others.mean());
  return half.mean();
}

/// Whether most of the character's ink is still to be seen.
bool still_shows(const camera::Frame& picture, const Box& box, const TextCell& text, int size) {
  if (!text.drawn) return false;
  if (size == 0) return text.code != ' ';
  const auto coverage =
      Font(text.family, text.style, size).glyph(static_cast<std::uint8_t>(text.code));
  // Small glyphs have no pixel that is ink and nothing else.
  const unsigned strongest = *std::max_element(coverage.begin(), coverage.end());
  int ink = 0;
  int seen = 0;
  std::size_t i = 0;
  each_pixel(picture, box, [&](Rgb pixel) {
    const unsigned c = coverage[i++];
    if (c == 0 || 2 * c < strongest) return;
    ++ink;
    if (pixel == inked(text.paper, text.ink, c)) ++seen;
  });
  return ink > 0 && 4 * seen >= 3 * ink;
}

/// A character as every terminal shows it in one cell: they do not agree on the soft hyphen.
char32_t glyph_of(std::uint8_t latin1) { return latin1 == 0xAD ? U'-' : latin1; }

ScreenCell graphic(const camera::Frame& picture, const Box& box) {
  const int middle = (box.top + box.bottom) / 2;
  const Rgb upper = colour_of(picture, {box.left, box.top, box.right, middle});
  const Rgb lower = colour_of(picture, {box.left, middle, box.right, box.bottom});
  return upper == lower ? ScreenCell{U' ', {}, upper} : ScreenCell{kUpperHalf, upper, lower};
}

ScreenCell cell_of(const ScreenShot& shot, const LcdView& view, int column, int row) {
  const camera::Frame& picture = shot.picture;
  const Box box{column * view.cell_width, row * view.cell_height,
                std::min((column + 1) * view.cell_width, picture.width),
                std::min((row + 1) * view.cell_height, picture.height)};
  if (row < shot.text_rows && column < shot.text_columns) {
    const TextCell& text =
        shot.text.at(static_cast<std::size_t>(row) * static_cast<std::size_t>(shot.text_columns) +
                     static_cast<std::size_t>(column));
    if (still_shows(picture, box, text, shot.font_size)) {
      return {glyph_of(static_cast<std::uint8_t>(text.code)), text.ink, text.paper};
    }
  }
  return graphic(picture, box);
}

/// The first column of the strip that counts as `key` (0..4, where 4 is the end).
int first_column(const LcdView& view, int key) {
  int column = 0;
  while (column < view.columns && pixel_under(view, column, view.top + view.rows - 1)->x <
                                      view.lcd_width * key / kSoftKeys) {
    ++column;
  }
  return column;
}

/// One soft key, in the columns [left, right) of the strip: its lines in the middle, one behind the
/// other where there is a single row.
void draw_key(CellGrid& grid, const SoftKeyLook& key, int left, int right, int top) {
  const int rows = grid.rows - top;
  std::string label = key.label;
  if (rows == 1) std::replace(label.begin(), label.end(), '\n', ' ');
  const std::vector<std::string> lines = latin1_lines(label);
  const int first = top + std::max(0, rows - static_cast<int>(lines.size())) / 2;
  for (int row = top; row < grid.rows; ++row) {
    const auto line = static_cast<std::size_t>(row - first);
    const std::string text = row >= first && line < lines.size() ? lines[line] : "";
    const int length = std::min(static_cast<int>(text.size()), right - left);
    const int start = left + (right - left - length) / 2;
    for (int column = left; column < right; ++column) {
      ScreenCell& cell = grid.at(column, row);
      cell = {U' ', {}, key.paper};
      if (column < start || column >= start + length) continue;
      const auto code = static_cast<std::uint8_t>(text[static_cast<std::size_t>(column - start)]);
      if (code > 32 && (code < 127 || code > 160)) cell = {glyph_of(code), key.ink, key.paper};
    }
  }
}

}  // namespace

CellGrid cells_of(const ScreenShot& shot, const LcdView& view) {
  CellGrid grid(view.columns, view.rows);
  const int strip = view.rows - view.strip;
  for (int row = 0; row < strip; ++row) {
    for (int column = 0; column < view.columns; ++column) {
      grid.at(column, row) = cell_of(shot, view, column, view.first_row + row);
    }
  }
  if (view.strip == 0) return grid;
  for (int key = 0; key < kSoftKeys; ++key) {
    draw_key(grid, shot.keys.at(static_cast<std::size_t>(key)), first_column(view, key),
             first_column(view, key + 1), strip);
  }
  return grid;
}

}  // namespace eyebridge::robios
