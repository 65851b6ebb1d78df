#include "trace_line.hpp"

#include <algorithm>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"

namespace eyebridge::bridges {
namespace {

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::size_t count_while(std::string_view text, bool (*wanted)(char)) {
  return static_cast<std::size_t>(std::ranges::find_if_not(text, wanted) - text.begin());
}

}  // namespace

bool LineReader::take(char c) {
  if (at_end() || line_[at_] != c) return false;
  ++at_;
  return true;
}

void LineReader::expect(char c) {
  if (!take(c)) fail(std::string("'") + c + "'");
}

void LineReader::expect_end() const {
  if (!at_end()) fail("the end of the line");
}

std::size_t LineReader::hex_digits() const {
  return count_while(line_.substr(at_), [](char c) { return digit_of(c) >= 0; });
}

std::size_t LineReader::decimal_digits() const {
  return count_while(line_.substr(at_), [](char c) { return c >= '0' && c <= '9'; });
}

std::uint32_t LineReader::hex(std::size_t digits, const char* what) {
  if (hex_digits() < digits) fail(std::string(what) + " in hex");
  std::uint32_t value = 0;
  for (const char c : line_.substr(at_, digits)) {
    value = value << 4 | static_cast<std::uint32_t>(digit_of(c));
  }
  at_ += digits;
  return value;
}

std::int64_t LineReader::number(std::int64_t most, const char* what) {
  const std::size_t digits = decimal_digits();
  std::int64_t value = 0;
  bool good = digits > 0;
  for (std::size_t i = 0; good && i < digits; ++i) {
    const int digit = digit_of(line_[at_ + i]);
    good = value <= (most - digit) / 10;
    value = good ? 10 * value + digit : value;
  }
  if (!good) fail(std::string("a number of ") + what + ", at most " + std::to_string(most));
  at_ += digits;
  return value;
}

std::string LineReader::word(const char* what) {
  const std::size_t length =
      count_while(line_.substr(at_), [](char c) { return c > 0x20 && c < 0x7F; });
  if (length == 0) fail(what);
  at_ += length;
  return std::string(line_.substr(at_ - length, length));
}

void LineReader::fail(const std::string& expected) const {
  const std::string found = at_end() ? "the end of the line" : in_quotes(line_.substr(at_));
  throw ConfigError({file_, number_, static_cast<int>(std::min<std::size_t>(at_, 1'000'000)) + 1},
                    "found " + found + ", expected " + expected);
}

}  // namespace eyebridge::bridges
