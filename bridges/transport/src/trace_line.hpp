#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace eyebridge::bridges {

/// Reads one line of a trace from left to right. Everything that is not as expected throws
/// ConfigError with the line and the column where that shows.
class LineReader {
 public:
  /// The latest time that a trace can have: what Time holds.
  static constexpr std::int64_t kMaxMicroseconds = std::numeric_limits<std::int64_t>::max() / 1000;

  /// Both texts must outlive the reader.
  LineReader(std::string_view line, const std::string& file, int number)
      : line_(line), file_(file), number_(number) {}

  [[nodiscard]] bool at_end() const { return at_ == line_.size(); }
  /// Steps over `c` if it is next.
  bool take(char c);
  void expect(char c);
  void expect_end() const;
  /// How many hex or decimal digits come next.
  [[nodiscard]] std::size_t hex_digits() const;
  [[nodiscard]] std::size_t decimal_digits() const;
  /// The next `digits` hex digits, at most 8.
  std::uint32_t hex(std::size_t digits, const char* what);
  /// All decimal digits that come next.
  std::int64_t number(std::int64_t most, const char* what);
  /// Everything up to the next blank: printable ASCII, at least one.
  std::string word(const char* what);
  /// Throws: found what comes next, expected `expected`.
  [[noreturn]] void fail(const std::string& expected) const;

 private:
  std::string_view line_;
  const std::string& file_;
  int number_;
  std::size_t at_ = 0;
};

}  // namespace eyebridge::bridges
