#include "eyebridge/base/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <vector>

namespace eyebridge {
namespace {

/// Bytes of the UTF-8 character that `text` begins with; 0 when it begins with none. Forms that are
/// longer than they need be count, for all they do is look odd.
std::size_t character_at(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t size = byte(0) < 0x80                      ? 1
                           : byte(0) >= 0xC2 && byte(0) < 0xE0 ? 2
                           : byte(0) >= 0xE0 && byte(0) < 0xF0 ? 3
                           : byte(0) >= 0xF0 && byte(0) < 0xF5 ? 4
                                                               : 0;
  if (size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return 0;
  }
  return size;
}

/// Of a character: C0, DEL, and C1, which terminals obey, too.
bool is_control(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 1) return byte(0) < 0x20 || byte(0) == 0x7F;
  return character.size() == 2 && byte(0) == 0xC2 && byte(1) < 0xA0;
}

struct Unit {
  std::string_view name;
  double seconds;
};
constexpr auto kUnits = std::to_array<Unit>(
    {{"", 1.0}, {"us", 1e-6}, {"ms", 1e-3}, {"s", 1.0}, {"min", 60.0}, {"h", 3600.0}});
constexpr double kLongestDuration = 1e9;  // seconds; from_seconds() holds for 9e9

}  // namespace

std::string in_quotes(std::string_view text, std::size_t most) {
  std::string out = "'";
  std::size_t i = 0;
  while (i < text.size() && i < most) {
    const std::size_t size = character_at(text.substr(i));
    if (size == 0 || is_control(text.substr(i, size))) {
      out += '?';
      i += std::max<std::size_t>(size, 1);
    } else {
      out.append(text.substr(i, size));
      i += size;
    }
  }
  return out.append(i < text.size() ? "…'" : "'");
}

std::string printable(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t size = character_at(text.substr(i));
    const std::string_view character = text.substr(i, std::max<std::size_t>(size, 1));
    i += character.size();
    if ((size != 0 && !is_control(character)) || character == "\n" || character == "\t") {
      out += character;
      continue;
    }
    for (const char c : character) {
      const auto byte = static_cast<unsigned char>(c);
      out.append("\\x").append(1, kDigits[byte >> 4U]).append(1, kDigits[byte & 15U]);
    }
  }
  return out;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U);
      row[j] = std::min({above + 1, row[j - 1] + 1, replaced});
      diagonal = above;
    }
  }
  return row[b.size()];
}

double parse_duration(std::string_view text, const SourceLocation& where) {
  const std::string_view word = trimmed(text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc{}) {
    const std::string_view unit = trimmed(word.substr(static_cast<std::size_t>(end - word.data())));
    const auto* row = std::ranges::find(kUnits, unit, &Unit::name);
    if (row != kUnits.end() && std::isfinite(value)) {
      const double seconds = value * row->seconds;
      if (seconds >= 0.0 && seconds <= kLongestDuration) return seconds;
      throw ConfigError(where, std::string("found ")
                                   .append(in_quotes(text))
                                   .append(", expected a duration of 0 … 1000000000 s"));
    }
  }
  throw ConfigError(where,
                    std::string("found ")
                        .append(in_quotes(text))
                        .append(", expected a duration such as 2s, 250ms, 1.5 min or 2 (seconds)"));
}

}  // namespace eyebridge
