#include "text_screen.hpp"

#include <algorithm>
#include <iterator>

#include "utf8.hpp"

namespace eyebridge::robios {
namespace {

constexpr int kTab = 8;
// Far outside any screen, and far from overflow when the cursor moves on.
constexpr int kFarthest = 1'000'000;

}  // namespace

TextScreen::TextScreen(int width, int height)
    : width_(width), height_(height), font_(family_, style_, size_) {
  apply_font();
}

void TextScreen::print(Canvas& canvas, std::string_view text) {
  if (std::any_of(text.begin(), text.end(), [](char c) { return (c & 0x80) != 0; })) {
    print_latin1(canvas, to_latin1(text));
  } else {
    print_latin1(canvas, text);
  }
}

void TextScreen::print_latin1(Canvas& canvas, std::string_view text) {
  for (const char c : text) {
    switch (c) {
      case '\n':
        new_line();
        break;
      case '\r':
        position_.column = 0;
        break;
      case '\b':
        position_.column = std::max(position_.column - 1, 0);
        break;
      case '\t':
        position_.column = (std::max(position_.column, 0) / kTab + 1) * kTab;
        break;
      default:
        put_if_visible(canvas, static_cast<std::uint8_t>(c));
    }
  }
}

void TextScreen::put_if_visible(Canvas& canvas, std::uint8_t code) {
  if (code >= 128 && code < 160) {
    put(canvas, '?');
  } else if (code >= 32 && code != 127) {
    put(canvas, code);
  }
}

void TextScreen::put(Canvas& canvas, std::uint8_t code) {
  if (wrapping_ && flowed_ && position_.column >= columns_) {
    new_line();
  }
  if (scrolling_ && flowed_ && position_.row >= rows_) {
    scroll(canvas, position_.row - rows_ + 1);
  }
  if (position_.row >= 0 && position_.row < rows_ && position_.column >= 0 &&
      position_.column < columns_) {
    canvas.stamp(position_.column * font_.cell_width(), position_.row * font_.cell_height(), font_,
                 picture_of(code));
    cells_[static_cast<std::size_t>(position_.row)][static_cast<std::size_t>(position_.column)] = {
        static_cast<char>(code), family_, style_, true, ink_, paper_};
    flowed_ = true;
  }
  position_.column = std::min(position_.column + 1, kFarthest);
}

void TextScreen::new_line() {
  flowed_ = flowed_ || (position_.row >= 0 && position_.row < rows_);
  position_.row = std::min(position_.row + 1, kFarthest);
  position_.column = 0;
}

void TextScreen::scroll(Canvas& canvas, int count) {
  const int rows = std::min(count, rows_);
  canvas.scroll_up(rows * font_.cell_height(), rows_ * font_.cell_height(), paper_);
  std::rotate(cells_.begin(), cells_.begin() + rows, cells_.end());
  blank(static_cast<std::size_t>(rows_ - rows));
  position_.row = rows_ - 1;
}

void TextScreen::blank(std::size_t first_row) {
  for (std::size_t row = first_row; row < cells_.size(); ++row) {
    std::copy(blank_.begin(), blank_.end(), cells_[row].begin());
  }
}

void TextScreen::clear() {
  blank(0);
  position_ = {};
  flowed_ = true;
  set_colours({255, 255, 255}, {});
}

void TextScreen::set_position(int row, int column) {
  position_ = {std::clamp(row, -kFarthest, kFarthest), std::clamp(column, -kFarthest, kFarthest)};
  // A cursor that the program itself put outside must not make the screen scroll or wrap.
  flowed_ = position_.row >= 0 && position_.row < rows_ && position_.column >= 0 &&
            position_.column < columns_;
}

void TextScreen::set_colours(Rgb ink, Rgb paper) {
  if (ink == ink_ && paper == paper_) return;
  ink_ = ink;
  paper_ = paper;
  forget_pictures();
}

void TextScreen::set_font(FontFamily family, FontStyle style) {
  family_ = family;
  style_ = style;
  apply_font();
}

void TextScreen::set_font_size(int size) {
  size_ = size;
  apply_font();
}

void TextScreen::apply_font() {
  const int before = font_.cell_width();
  font_ = Font(family_, style_, size_);
  forget_pictures();
  rows_ = height_ / font_.cell_height();
  columns_ = width_ / font_.cell_width();
  cells_.resize(static_cast<std::size_t>(rows_));
  blank_.assign(static_cast<std::size_t>(columns_), {});
  for (auto& row : cells_) {
    row.resize(static_cast<std::size_t>(columns_));
    if (font_.cell_width() == before) continue;
    for (TextCell& cell : row) cell.drawn = false;
  }
}

void TextScreen::forget_pictures() {
  pictures_.clear();
  numbers_.fill(0);
}

const Rgb* TextScreen::picture_of(std::uint8_t code) {
  const auto coverage = font_.glyph(code);
  std::uint16_t& number = numbers_[code];
  if (number == 0) {
    number = static_cast<std::uint16_t>(pictures_.size() / coverage.size() + 1);
    std::transform(coverage.begin(), coverage.end(), std::back_inserter(pictures_),
                   [&](std::uint8_t c) { return inked(paper_, ink_, c); });
  }
  return &pictures_[(number - std::size_t{1}) * coverage.size()];
}

std::vector<TextCell> TextScreen::cells() const {
  std::vector<TextCell> all;
  all.reserve(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_));
  for (const auto& row : cells_) all.insert(all.end(), row.begin(), row.end());
  return all;
}

std::vector<std::string> TextScreen::rows_as_text() const {
  std::vector<std::string> rows;
  for (const auto& cells : cells_) {
    std::string row;
    for (const TextCell& cell : cells) row += cell.code;
    rows.push_back(to_utf8(std::string_view(row).substr(0, row.find_last_not_of(' ') + 1)));
  }
  return rows;
}

}  // namespace eyebridge::robios
