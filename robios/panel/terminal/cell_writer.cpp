#include "terminal/cell_writer.hpp"

#include <iterator>
#include <optional>

#include <fmt/format.h>

namespace eyebridge::robios {
namespace {

bool look_equal(Rgb a, Rgb b, ColourDepth depth) {
  return a == b || (depth == ColourDepth::Palette256 && palette_index(a) == palette_index(b));
}

bool look_equal(const ScreenCell& a, const ScreenCell& b, ColourDepth depth) {
  return a.glyph == b.glyph && look_equal(a.ink, b.ink, depth) &&
         look_equal(a.paper, b.paper, depth);
}

/// Writes cells one after the other and remembers colours and place.
class Pen {
 public:
  Pen(int top, ColourDepth depth) : top_(top), depth_(depth) {}

  void put(const ScreenCell& cell, int column, int row) {
    if (column != column_ || row != row_) {
      fmt::format_to(std::back_inserter(out_), "\x1b[{};{}H", top_ + row + 1, column + 1);
    }
    // Attributes that the program's own output left behind would show through.
    if (!paper_) out_ += "\x1b[0m";
    if (cell.glyph != U' ' && cell.ink != ink_) {
      ink_ = cell.ink;
      select("38", cell.ink);
    }
    if (cell.paper != paper_) {
      paper_ = cell.paper;
      select("48", cell.paper);
    }
    add(cell.glyph);
    column_ = column + 1;
    row_ = row;
  }

  std::string take() { return std::move(out_); }

 private:
  /// Of ISO 8613-6: "38" is the ink, "48" the paper.
  void select(const char* what, Rgb colour) {
    if (depth_ == ColourDepth::True) {
      fmt::format_to(std::back_inserter(out_), "\x1b[{};2;{};{};{}m", what, colour.r, colour.g,
                     colour.b);
    } else {
      fmt::format_to(std::back_inserter(out_), "\x1b[{};5;{}m", what, palette_index(colour));
    }
  }

  void add(char32_t glyph) {
    const auto byte = [&](char32_t bits) { out_ += static_cast<char>(bits); };
    if (glyph < 0x80) {
      byte(glyph);
    } else if (glyph < 0x800) {
      byte(0xC0 | glyph >> 6);
      byte(0x80 | (glyph & 0x3F));
    } else {
      byte(0xE0 | glyph >> 12);
      byte(0x80 | (glyph >> 6 & 0x3F));
      byte(0x80 | (glyph & 0x3F));
    }
  }

  int top_;
  ColourDepth depth_;
  std::string out_;
  int column_ = -1;
  int row_ = -1;
  std::optional<Rgb> ink_;
  std::optional<Rgb> paper_;
};

}  // namespace

std::string changed_cells(const CellGrid& before, const CellGrid& after, int top,
                          ColourDepth depth) {
  const bool all = before.columns != after.columns || before.rows != after.rows;
  Pen pen(top, depth);
  for (int row = 0; row < after.rows; ++row) {
    for (int column = 0; column < after.columns; ++column) {
      const ScreenCell& cell = after.at(column, row);
      if (all || !look_equal(before.at(column, row), cell, depth)) pen.put(cell, column, row);
    }
  }
  return pen.take();
}

}  // namespace eyebridge::robios
