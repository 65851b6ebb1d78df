#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvas.hpp"
#include "eyebridge/base/colour.hpp"
#include "font.hpp"

namespace eyebridge::robios {

/// A text cursor's place in cells from the top left.
struct TextPosition {
  int row = 0;
  int column = 0;

  friend bool operator==(const TextPosition&, const TextPosition&) = default;
};

/// A character as it was last drawn in its cell, whatever was drawn over it since.
struct TextCell {
  char code = ' ';  ///< Latin-1.
  FontFamily family = FontFamily::Helvetica;
  FontStyle style = FontStyle::Normal;
  bool drawn = false;  ///< False for an empty cell, and for text printed in another size.
  Rgb ink;
  Rgb paper;

  friend bool operator==(const TextCell&, const TextCell&) = default;
};

/// Text on a canvas: cursor, cells, wrapping and scrolling, and a copy of the characters. One
/// thread; the canvas is lent to each call.
class TextScreen {
 public:
  /// Text stays within width x height pixels.
  TextScreen(int width, int height);

  /// Draws `text` cell by cell: '\n' next row, '\r' column 0, '\t' next multiple of 8, '\b' one
  /// back, other control characters nothing. UTF-8; bytes that are not are taken as Latin-1, and
  /// characters beyond Latin-1 become '?'. The screen scrolls only when a character is to be drawn
  /// in a row that the text itself has reached below the last one; text that was placed outside by
  /// set_position() is cut off.
  void print(Canvas& canvas, std::string_view text);
  /// Forgets the characters, cursor home, white on black. The canvas is the caller's to blank.
  void clear();

  void set_position(int row, int column);
  [[nodiscard]] TextPosition position() const { return position_; }
  void set_colours(Rgb ink, Rgb paper);
  void set_font(FontFamily family, FontStyle style);
  void set_font_size(int size);  ///< One of font_sizes().
  void set_scrolling(bool on) { scrolling_ = on; }
  void set_wrapping(bool on) { wrapping_ = on; }

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int font_size() const { return size_; }
  [[nodiscard]] int cell_width() const { return font_.cell_width(); }
  [[nodiscard]] int cell_height() const { return font_.cell_height(); }
  /// Of all rows, one after the other: rows() x columns().
  [[nodiscard]] std::vector<TextCell> cells() const;
  /// Characters as UTF-8, one string a row, trailing blanks cut.
  [[nodiscard]] std::vector<std::string> rows_as_text() const;

 private:
  void print_latin1(Canvas& canvas, std::string_view text);
  void put_if_visible(Canvas& canvas, std::uint8_t code);
  void put(Canvas& canvas, std::uint8_t code);
  void new_line();
  void scroll(Canvas& canvas, int count);
  void apply_font();
  void blank(std::size_t first_row);
  void forget_pictures();
  const Rgb* picture_of(std::uint8_t code);

  int width_;
  int height_;
  FontFamily family_ = FontFamily::Helvetica;
  FontStyle style_ = FontStyle::Normal;
  int size_ = 12;
  Font font_;
  int rows_ = 0;
  int columns_ = 0;
  TextPosition position_;
  bool flowed_ = true;  // the text itself, not set_position(), brought the cursor to its row
  bool scrolling_ = true;
  bool wrapping_ = true;
  Rgb ink_{255, 255, 255};
  Rgb paper_{};
  std::vector<std::vector<TextCell>> cells_;  // always rows_ x columns_
  std::vector<TextCell> blank_;               // a row of them
  // Glyphs in the present font and colours, mixed when first asked for: printing copies them. Those
  // of most codes never are.
  std::vector<Rgb> pictures_;
  std::array<std::uint16_t, 256> numbers_{};  // of the codes' pictures, from 1; 0: not mixed yet
};

}  // namespace eyebridge::robios
