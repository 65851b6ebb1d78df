#include "config/toml_ascii.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

namespace eyebridge::hal {
namespace {

constexpr char kMark = '~';

}  // namespace

std::string to_ascii(std::string_view text, const std::string& file) {
  for (const std::string_view spelled : {"\\u007E", "\\u007e", "\\U0000007E", "\\U0000007e"}) {
    if (const std::size_t at = text.find(spelled); at != std::string_view::npos) {
      const auto lines = std::ranges::count(text.substr(0, at), '\n');
      throw ConfigError({file, static_cast<int>(lines) + 1},
                        fmt::format("found {}, expected ~ as it is", spelled));
    }
  }
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == kMark || byte >= 0x80) {
      out += fmt::format("{}{:02x}", kMark, byte);
    } else {
      out += c;
    }
  }
  return out;
}

std::string from_ascii(std::string_view ascii) {
  std::string out;
  for (std::size_t i = 0; i < ascii.size(); ++i) {
    if (ascii[i] != kMark || i + 2 >= ascii.size()) {
      out += ascii[i];
      continue;
    }
    unsigned byte = 0;
    std::from_chars(&ascii[i] + 1, &ascii[i] + 3, byte, 16);
    out += static_cast<char>(byte);
    i += 2;
  }
  return out;
}

SourceLocation original_place(std::string_view ascii, SourceLocation where) {
  for (int line = 1; line < where.line; ++line) {
    ascii.remove_prefix(std::min(ascii.find('\n') + 1, ascii.size()));
  }
  const auto before = static_cast<std::size_t>(std::max(where.column - 1, 0));
  const std::string original = from_ascii(ascii.substr(0, before));
  // Bytes 10xxxxxx go on a UTF-8 character.
  const auto characters = std::ranges::count_if(
      original, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  where.column = static_cast<int>(characters) + 1;
  return where;
}

}  // namespace eyebridge::hal
