#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::bridges::dbc {

/// Walks through the text of a DBC file. What is asked for and not there is a ConfigError with its
/// place, which names `expected`.
class Scanner {
 public:
  /// `text` must outlive it.
  Scanner(std::string_view text, std::string file);

  /// Whether line ends count as blanks, as in statements that end in ';'.
  void cross_lines(bool may) { crosses_lines_ = may; }

  // All of these skip blanks first.
  [[nodiscard]] bool at_end();
  /// The end of the line, or of the text.
  [[nodiscard]] bool at_line_end();
  [[nodiscard]] char peek();  ///< '\0' at the end, or of the line.
  bool take(char wanted);
  void expect(char wanted);
  /// A run of anything but blanks and punctuation.
  std::string_view word(std::string_view expected);
  [[nodiscard]] std::string_view peek_word();
  /// Digits only; at most `most`.
  std::uint64_t whole(std::string_view expected, std::uint64_t most);
  /// Finite: what is too large for a double is the largest one.
  double number(std::string_view expected);
  /// What is between double quotes, which a backslash takes the meaning from; over line ends.
  std::string text(std::string_view expected);

  void skip_line();
  /// To the end of a statement of an unknown kind: ';', or a line that begins another one.
  void skip_statement();
  /// Ends a statement: by ';', or where the next line begins.
  void end_statement();

  [[nodiscard]] std::size_t position() {
    skip_blanks();
    return at_;
  }
  void back_to(std::size_t position) { at_ = position; }
  [[nodiscard]] SourceLocation place(std::size_t position) const;
  [[nodiscard]] int line() const { return place(at_).line; }
  /// Throws: found what is here.
  [[noreturn]] void refuse(std::string_view expected);
  [[noreturn]] void refuse_at(std::size_t position, const std::string& text) const;

 private:
  void skip_blanks();
  [[nodiscard]] bool begins_statement(std::size_t position) const;

  std::string_view text_;
  std::string file_;
  std::vector<std::size_t> lines_;  ///< Where each begins.
  std::size_t at_ = 0;
  bool crosses_lines_ = false;
};

}  // namespace eyebridge::bridges::dbc
