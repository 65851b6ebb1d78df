#include "mono_lcd.hpp"

#include <algorithm>

#include "font_grid.hpp"
#include "utf8.hpp"

namespace eyebridge::robios {
namespace {

constexpr Rgb kInk{0, 0, 0};
constexpr Rgb kPaper{255, 255, 255};
constexpr int kTabWidth = 8;
constexpr int kCursorRow = MonoLcd::kCell - 1;  // of its cell
constexpr int kTextHeight = MonoLcd::kRows * MonoLcd::kCell;

// Written by bake_mono_font: eight rows a glyph.
constexpr char kMonoGlyphs[] =
#include "mono_font_data.inc"
    ;
static_assert(sizeof kMonoGlyphs == std::size_t{kGlyphCount} * MonoLcd::kCell + 1);

std::string blank_row() { return std::string(MonoLcd::kColumns, ' '); }

std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace

bool is_white(int x, int y, std::uint8_t grey) {
  static constexpr std::array<std::array<int, 2>, 2> kThresholds{{{51, 153}, {204, 102}}};
  return grey > kThresholds.at(static_cast<std::size_t>(y & 1)).at(static_cast<std::size_t>(x & 1));
}

MonoLcd::MonoLcd() { clear(); }

void MonoLcd::draw_cell(int row, int column, std::uint8_t code) {
  const int glyph = glyph_of_latin1(code);
  for (int y = 0; y < kCell; ++y) {
    const int bits = kMonoGlyphs[glyph * kCell + y];
    for (int x = 0; x < kCell; ++x) {
      canvas_.pixel(column * kCell + x, row * kCell + y, (bits & 0x80 >> x) != 0 ? kInk : kPaper);
    }
  }
  cells_.at(static_cast<std::size_t>(row)).at(static_cast<std::size_t>(column)) =
      static_cast<char>(code);
}

void MonoLcd::new_line() {
  make_room();
  cursor_ = {cursor_.row + 1, 0};
}

/// Text that is to be drawn must not be below the screen.
void MonoLcd::make_room() {
  if (cursor_.row < kRows) return;
  if (!scrolling_) {
    cursor_.row = 0;
    return;
  }
  cursor_.row = kRows - 1;
  canvas_.scroll_up(kCell, kTextHeight, kPaper);
  std::rotate(cells_.begin(), cells_.begin() + 1, cells_.begin() + kRows);
  cells_.at(kRows - 1) = blank_row();
}

void MonoLcd::put(std::uint8_t code) {
  if (cursor_.column >= kColumns) new_line();
  make_room();
  draw_cell(cursor_.row, cursor_.column, code);
  ++cursor_.column;
}

void MonoLcd::print(std::string_view text) {
  const std::lock_guard lock(mutex_);
  for (const char c : to_latin1(text)) {
    const auto code = static_cast<std::uint8_t>(c);
    if (c == '\n') {
      new_line();
    } else if (c == '\r') {
      cursor_.column = 0;
    } else if (c == '\b') {
      cursor_.column = std::max(cursor_.column - 1, 0);
    } else if (c == '\t') {
      cursor_.column = std::min((cursor_.column / kTabWidth + 1) * kTabWidth, kColumns);
    } else if (code >= 32 && code != 127) {
      put(code);
    }
  }
  ++revision_;
}

Result<void> MonoLcd::print_at(int row, int column, std::string_view text) {
  return set_position(row, column).map([&] { print(text); });
}

void MonoLcd::clear() {
  const std::lock_guard lock(mutex_);
  canvas_.area(0, 0, kWidth - 1, kHeight - 1, kPaper, true);
  cells_.fill(blank_row());
  cursor_ = {};
  ++revision_;
}

Result<void> MonoLcd::set_position(int row, int column) {
  if (row < 0 || row >= kRows || column < 0 || column >= kColumns) {
    return fail(Errc::OutOfRange, "row " + std::to_string(row) + ", column " +
                                      std::to_string(column) + ", expected 0..6 and 0..15");
  }
  const std::lock_guard lock(mutex_);
  cursor_ = {row, column};
  ++revision_;
  return {};
}

TextPosition MonoLcd::position() const {
  const std::lock_guard lock(mutex_);
  return {std::min(cursor_.row, kRows - 1), std::min(cursor_.column, kColumns - 1)};
}

void MonoLcd::set_mode(bool scrolling, bool show_cursor) {
  const std::lock_guard lock(mutex_);
  scrolling_ = scrolling;
  cursor_shown_ = show_cursor;
  ++revision_;
}

void MonoLcd::set_label(std::size_t key, std::string_view label) {
  if (label.empty()) return;
  const std::string text = to_latin1(label);
  const std::lock_guard lock(mutex_);
  for (std::size_t i = 0; i < kLabel; ++i) {
    draw_cell(kRows, static_cast<int>(key * kLabel + i),
              static_cast<std::uint8_t>(i < text.size() ? text[i] : ' '));
  }
  ++revision_;
}

Result<void> MonoLcd::pixel(int x, int y, Pen pen) {
  const std::lock_guard lock(mutex_);
  if (!canvas_.contains(x, y)) {
    return fail(Errc::OutOfRange, "no pixel in row " + std::to_string(y) + ", column " +
                                      std::to_string(x) + ", expected 0..63 and 0..127");
  }
  if (pen == Pen::Invert) {
    canvas_.invert_pixel(x, y);
  } else {
    canvas_.pixel(x, y, pen == Pen::Set ? kInk : kPaper);
  }
  ++revision_;
  return {};
}

Result<bool> MonoLcd::pixel_at(int x, int y) const {
  const std::lock_guard lock(mutex_);
  if (!canvas_.contains(x, y)) {
    return fail(Errc::OutOfRange, "no pixel in row " + std::to_string(y) + ", column " +
                                      std::to_string(x) + ", expected 0..63 and 0..127");
  }
  return canvas_.at(x, y) == kInk;
}

void MonoLcd::line(int x1, int y1, int x2, int y2, Pen pen) {
  const std::lock_guard lock(mutex_);
  if (pen == Pen::Invert) {
    canvas_.invert_line(x1, y1, x2, y2);
  } else {
    canvas_.line(x1, y1, x2, y2, pen == Pen::Set ? kInk : kPaper);
  }
  ++revision_;
}

void MonoLcd::area(int x1, int y1, int x2, int y2, Pen pen) {
  const std::lock_guard lock(mutex_);
  if (pen == Pen::Invert) {
    canvas_.invert_area(x1, y1, x2, y2);
  } else {
    canvas_.area(x1, y1, x2, y2, pen == Pen::Set ? kInk : kPaper, true);
  }
  ++revision_;
}

void MonoLcd::picture(int x, int y, int width, int height, const std::uint8_t* grey,
                      std::size_t stride) {
  const std::lock_guard lock(mutex_);
  const int last_x = static_cast<int>(std::min<std::int64_t>(std::int64_t{x} + width, kWidth));
  const int last_y = static_cast<int>(std::min<std::int64_t>(std::int64_t{y} + height, kTextHeight));
  for (int v = std::max(y, 0); v < last_y; ++v) {
    for (int u = std::max(x, 0); u < last_x; ++u) {
      const auto row = static_cast<std::size_t>(std::int64_t{v} - y);
      const auto column = static_cast<std::size_t>(std::int64_t{u} - x);
      const bool white = is_white(static_cast<int>(column), static_cast<int>(row),
                                  grey[row * stride + column]);
      canvas_.pixel(u, v, white ? kPaper : kInk);
    }
  }
  ++revision_;
}

void MonoLcd::bitmap(const std::uint8_t* bits) {
  const std::lock_guard lock(mutex_);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool black = (bits[y * kWidth / 8 + x / 8] & 0x80 >> x % 8) != 0;
      canvas_.pixel(x, y, black ? kInk : kPaper);
    }
  }
  ++revision_;
}

camera::Frame MonoLcd::snapshot() const {
  const std::lock_guard lock(mutex_);
  camera::Frame frame;
  frame.width = kWidth;
  frame.height = kHeight;
  frame.stride = 3 * kWidth;
  frame.format = camera::PixelFormat::Rgb24;
  frame.sequence = revision_;
  frame.bytes.reserve(std::size_t{3} * kWidth * kHeight);
  const int row = std::min(cursor_.row, kRows - 1);
  const int column = std::min(cursor_.column, kColumns - 1);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool cursor = cursor_shown_ && y == row * kCell + kCursorRow && x / kCell == column;
      const bool black = (canvas_.at(x, y) == kInk) != cursor;
      frame.bytes.insert(frame.bytes.end(), 3, black ? kInk.r : kPaper.r);
    }
  }
  return frame;
}

std::vector<std::string> MonoLcd::text_rows() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> rows;
  for (const std::string& row : cells_) rows.push_back(to_utf8(trimmed(row)));
  return rows;
}

std::array<std::string, kSoftKeys> MonoLcd::menu_labels() const {
  const std::lock_guard lock(mutex_);
  std::array<std::string, kSoftKeys> labels;
  for (std::size_t key = 0; key < labels.size(); ++key) {
    labels.at(key) = to_utf8(trimmed(cells_.at(kRows).substr(key * kLabel, kLabel)));
  }
  return labels;
}

int MonoLcd::key_at(int x, int y) const {
  if (x < 0 || x >= kWidth || y < kTextHeight || y >= kHeight) return 0;
  return 1 << (x / (kLabel * kCell));
}

std::uint64_t MonoLcd::revision() const {
  const std::lock_guard lock(mutex_);
  return revision_;
}

}  // namespace eyebridge::robios
