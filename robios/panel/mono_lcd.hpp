#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "canvas.hpp"
#include "eyebridge/base/result.hpp"
#include "screen.hpp"
#include "text_screen.hpp"

namespace eyebridge::robios {

/// The screen of classic EyeBots: 128 x 64 pixels, black on white, for 7 rows of 16 characters and an
/// eighth row with the labels of the four keys. Any thread: every call locks for itself.
class MonoLcd final : public Screen {
 public:
  static constexpr int kWidth = 128;
  static constexpr int kHeight = 64;
  static constexpr int kCell = 8;
  static constexpr int kRows = 7;  ///< Of text; the labels are below.
  static constexpr int kColumns = kWidth / kCell;
  static constexpr int kLabel = kColumns / kSoftKeys;  ///< Characters of a label.

  enum class Pen { Clear, Set, Invert };

  MonoLcd();

  /// Prints at the cursor; UTF-8 or Latin-1. A full row goes on in the next one, as soon as there is
  /// a character for it; then, too, the screen scrolls. '\n', '\r', '\b', '\t' move the cursor, other
  /// control characters do nothing.
  void print(std::string_view text);
  /// Moves the cursor and prints, as one step. OutOfRange as set_position().
  Result<void> print_at(int row, int column, std::string_view text);
  /// White, the labels too; cursor home.
  void clear();
  /// OutOfRange unless row and column are those of a character.
  Result<void> set_position(int row, int column);
  [[nodiscard]] TextPosition position() const;
  /// Not scrolling: what is too much for the screen goes on at its top.
  void set_mode(bool scrolling, bool show_cursor);
  /// Label 0 … 3; "" changes nothing, what is longer than kLabel is cut off.
  void set_label(std::size_t key, std::string_view label);

  /// OutOfRange outside the screen.
  Result<void> pixel(int x, int y, Pen pen);
  [[nodiscard]] Result<bool> pixel_at(int x, int y) const;
  /// Bresenham's line, both ends included; what lies outside is cut off, as with area().
  void line(int x1, int y1, int x2, int y2, Pen pen);
  /// Both corners included, in any order.
  void area(int x1, int y1, int x2, int y2, Pen pen);
  /// A grey picture of width x height pixels, rows `stride` bytes apart, by thresholds() over the text
  /// rows only. Only the visible part is read.
  void picture(int x, int y, int width, int height, const std::uint8_t* grey, std::size_t stride);
  /// The whole screen, 1024 bytes: rows of 16, the highest bit left, 1 is black.
  void bitmap(const std::uint8_t* bits);

  [[nodiscard]] camera::Frame snapshot() const override;
  [[nodiscard]] std::vector<std::string> text_rows() const override;
  [[nodiscard]] std::array<std::string, kSoftKeys> menu_labels() const override;
  [[nodiscard]] int key_at(int x, int y) const override;
  [[nodiscard]] std::uint64_t revision() const override;

 private:
  void put(std::uint8_t code);
  void new_line();
  void make_room();
  void draw_cell(int row, int column, std::uint8_t code);

  mutable std::mutex mutex_;
  Canvas canvas_{kWidth, kHeight};
  std::array<std::string, kRows + 1> cells_;  ///< Latin-1; the last row are the labels.
  TextPosition cursor_;  ///< May be one beyond the last column or row until there is more text.
  bool scrolling_ = true;
  bool cursor_shown_ = false;
  std::uint64_t revision_ = 0;
};

/// Whether a pixel of this brightness at x, y is white when it must be black or white: brighter than
/// the threshold of its place in a pattern of 2 x 2, 51 153 over 204 102 (ordered dithering). Pure.
bool is_white(int x, int y, std::uint8_t grey);

}  // namespace eyebridge::robios
