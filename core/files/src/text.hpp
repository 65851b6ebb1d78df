#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/files/scenario.hpp"

namespace eyebridge::files {

/// Longest line any reader takes, bytes.
inline constexpr std::size_t kMaxLine = 65536;
/// Largest length or coordinate any file may give, millimetres (10 km).
inline constexpr double kMaxMillimetres = 1e7;

/// Throws ConfigError unless `text` is text: no NUL, no control bytes, no over-long line.
void check_text(std::string_view text, const std::string& file);

/// `text` without its byte order mark, if it has one.
std::string_view without_bom(std::string_view text);

/// ASCII only; other bytes stay as they are.
std::string lower(std::string_view word);

/// The candidate nearest to `word`, case ignored, when it is at most two edits away; else "".
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// `text` as a finite decimal number; nothing when it is anything else.
std::optional<double> parse_number(std::string_view text);

/// "a, b or c"
std::string one_of(std::span<const std::string_view> words);

/// Collects a reader's warnings; the first 100 of them, then one that says that more were met.
class Warnings {
 public:
  Warnings(const std::string& file, std::vector<Warning>& out) : file_(file), out_(out) {}

  void add(int line, int column, std::string text);

 private:
  static constexpr int kMost = 100;
  const std::string& file_;
  std::vector<Warning>& out_;
  int count_ = 0;
};

/// A word of a line.
struct Token {
  std::string_view text;  ///< Without its quotes.
  int column = 0;         ///< From 1.
  bool quoted = false;
};

/// One line with something on it besides a comment: a keyword, then its arguments.
///
/// Borrows from the text it was read from and from the file name; short-lived.
class Statement {
 public:
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] std::size_t size() const { return tokens_.size(); }
  [[nodiscard]] const Token& token(std::size_t i) const { return tokens_[i]; }
  [[nodiscard]] std::string_view text(std::size_t i) const { return tokens_[i].text; }
  /// The rest of the line from token `i`, comment and surrounding blanks removed.
  [[nodiscard]] std::string rest(std::size_t i) const;
  /// Token `i`, or the end of the line when there are fewer.
  [[nodiscard]] SourceLocation where(std::size_t i) const;
  /// Throws ConfigError at token `i`.
  [[noreturn]] void fail(std::size_t i, const std::string& text) const;

  /// Throws unless there are exactly `count` arguments; `form` is how the line should read.
  void expect_arguments(std::size_t count, std::string_view form) const;
  /// Throws unless the count of arguments is one of `counts`.
  void expect_arguments(std::initializer_list<std::size_t> counts, std::string_view form) const;

  /// True when token `i` exists and is a finite number.
  [[nodiscard]] bool is_number(std::size_t i) const;
  /// Token `i` as a number in [low, high], in the unit of the file; `what` names it in messages.
  [[nodiscard]] double number(std::size_t i, std::string_view what, double low, double high) const;
  /// Token `i` as a whole number in [low, high].
  [[nodiscard]] int integer(std::size_t i, std::string_view what, int low, int high) const;
  /// Token `i`, written in millimetres, in metres: the double nearest to the written decimal.
  [[nodiscard]] double millimetres(std::size_t i, std::string_view what,
                                   double low = -kMaxMillimetres,
                                   double high = kMaxMillimetres) const;
  /// Token `i`, written in degrees (or in radians with the suffix `rad`), in radians.
  [[nodiscard]] double degrees(std::size_t i, std::string_view what) const;

 private:
  friend class StatementReader;
  const std::string* file_ = nullptr;
  int line_ = 0;
  std::string_view raw_;  ///< The line up to its comment.
  std::vector<Token> tokens_;
};

/// Splits text into statements. `#` and `;` start a comment outside quotes; quotes, single or
/// double, count at the start of a word.
class StatementReader {
 public:
  /// Checks the whole text first; throws ConfigError. `text` and `file` must outlive the reader.
  StatementReader(std::string_view text, const std::string& file);

  /// False at the end. Throws ConfigError for a quote that is not closed.
  bool next(Statement& statement);
  /// Number of the line read last.
  [[nodiscard]] int line() const { return line_; }

 private:
  std::string_view rest_;
  const std::string& file_;
  int line_ = 0;
};

/// Lines that a file may have which cannot be used: with more it is of another kind, or too large.
inline constexpr int kMostLeftOut = 10'000;

/// Hands each statement to `read`. Where reading is Tolerant, what that throws is a warning, up to
/// kMostLeftOut.
template <class Read>
void read_lines(StatementReader& statements, Warnings& warnings, Reading reading, Read read) {
  Statement s;
  int left_out = 0;
  for (bool more = true; more;) {
    try {
      more = statements.next(s);
      if (more) read(s);
    } catch (const ConfigError& error) {
      if (reading == Reading::Strict) throw;
      if (++left_out > kMostLeftOut) {
        throw ConfigError(error.where(), error.text() + "; " + std::to_string(kMostLeftOut) +
                                             " lines before it cannot be used either");
      }
      warnings.add(error.where().line, error.where().column,
                   error.text() + "; the line is left out");
    }
  }
}

/// The shortest decimal number that is read back as `value`.
std::string decimal(double value);
/// `metres` as a decimal number of millimetres that Statement::millimetres() reads back unchanged.
std::string write_millimetres(double metres);
/// `radians` in degrees, or with the suffix `rad` where no number of degrees reads back unchanged.
std::string write_degrees(double radians);
/// `word` so that it is read back as one token; "" when there is no way to write it.
std::string write_word(std::string_view word);

}  // namespace eyebridge::files
