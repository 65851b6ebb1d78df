#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace eyebridge::testing {

/// A terminal as far as the panel needs one, after ECMA-48 and XTerm Control Sequences: UTF-8,
/// cursor, scrolling region, colours, mouse modes. What it does not know it remembers as unknown().
class TerminalEmulator {
 public:
  static constexpr int kDefault = -1;
  static constexpr int kPalette = 0x1000000;

  struct Cell {
    char32_t glyph = U' ';
    int ink = kDefault;  ///< 0xRRGGBB, kPalette + number, or kDefault.
    int paper = kDefault;

    friend bool operator==(const Cell&, const Cell&) = default;
  };

  TerminalEmulator(int columns, int rows);

  void feed(std::string_view bytes);
  /// As a window manager does: the rows are kept from the top, and the region is gone.
  void resize(int columns, int rows);

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] const Cell& at(int column, int row) const;
  /// A row's characters (Latin-1 only, others as '#'), without blanks at its end.
  [[nodiscard]] std::string text(int row) const;
  /// Rows that scrolled out at the top of the window, the oldest first.
  [[nodiscard]] const std::vector<std::string>& history() const { return history_; }
  [[nodiscard]] int cursor_row() const { return now_.row; }
  [[nodiscard]] int cursor_column() const { return now_.column; }
  /// The scrolling region is smaller than the window.
  [[nodiscard]] bool has_region() const { return top_ != 0 || bottom_ != rows_ - 1; }
  [[nodiscard]] bool reports_clicks() const { return mouse_ && sgr_; }
  [[nodiscard]] const std::string& unknown() const { return unknown_; }

 private:
  struct State {
    int column = 0;
    int row = 0;
    bool wraps = false;  ///< The last column is written: the next character wraps.
    int ink = kDefault;
    int paper = kDefault;
  };

  void character(char32_t code);
  void control(char byte);
  void escape(char byte);
  void sequence(char last);
  void select_graphics();
  void line_feed();
  [[nodiscard]] std::size_t index(int column, int row) const;

  int columns_;
  int rows_;
  std::vector<Cell> cells_;
  std::vector<std::string> history_;
  State now_;
  State saved_;
  int top_ = 0;
  int bottom_;
  bool mouse_ = false;
  bool sgr_ = false;

  enum class Reading { Ground, Escape, Sequence } reading_ = Reading::Ground;
  std::string parameters_;
  char32_t code_ = 0;  ///< Of a character of several bytes, and how many are still to come.
  int following_ = 0;
  std::string unknown_;
};

}  // namespace eyebridge::testing
