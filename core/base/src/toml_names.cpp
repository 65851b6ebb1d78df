#include "eyebridge/base/toml_names.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge {
namespace {

/// toml++ goes one call deeper with each part of a name, until its stack is full.
constexpr std::ptrdiff_t kMostDots = 1000;

/// Letters, digits, '-', '_', a quote; and ']', which toml++ refuses itself.
bool begins_name(char c) {
  const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return is_letter || (c >= '0' && c <= '9') ||
         std::string_view("-_\"']").find(c) != std::string_view::npos;
}

std::size_t past_blanks(std::string_view text, std::size_t at) {
  return std::min(text.find_first_not_of(" \t", at), text.size());
}

}  // namespace

void check_table_names(std::string_view toml, const std::string& file) {
  int line = 1;
  for (std::size_t begin = 0; begin < toml.size(); ++line) {
    std::size_t at = past_blanks(toml, begin);
    if (at < toml.size() && toml[at] == '[') {
      at = past_blanks(toml, at + 1);
      if (at < toml.size() && toml[at] == '[') at = past_blanks(toml, at + 1);
      if (at < toml.size() && !begins_name(toml[at])) {
        throw ConfigError(
            {file, line, static_cast<int>(at - begin) + 1},
            "found a table without a name, expected a letter, digit, '-', '_' or quote");
      }
    }
    const std::size_t end = std::min(toml.find('\n', begin), toml.size() - 1) + 1;
    const std::string_view whole = toml.substr(begin, end - begin);
    if (std::ranges::count(whole, '.') > kMostDots) {
      throw ConfigError({file, line, 1}, "found more than " + std::to_string(kMostDots) +
                                             " dots in a line, expected a name of fewer parts");
    }
    begin = end;
  }
}

}  // namespace eyebridge
