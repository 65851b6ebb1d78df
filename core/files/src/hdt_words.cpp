#include "hdt_words.hpp"

#include <algorithm>
#include <charconv>

namespace eyebridge::files {

int hex(const Statement& s, std::size_t i, std::string_view what) {
  if (i >= s.size()) s.fail(i, "line ends: expected " + std::string(what));
  std::string_view digits = s.text(i);
  if (digits.starts_with("0x") || digits.starts_with("0X")) digits.remove_prefix(2);
  int value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value, 16);
  if (error != std::errc{} || stop != end || value < 0) {
    s.fail(i, in_quotes(s.text(i)) + " found: expected " + std::string(what) +
                  ", a hexadecimal number of at most 31 bits");
  }
  return value;
}

std::string commas_blanked(std::string_view text) {
  std::string out(text);
  for (std::size_t start = 0; start < out.size();) {
    const std::size_t end = std::min(out.find('\n', start), out.size());
    const std::size_t word = std::min(out.find_first_not_of(" \t", start), end);
    const std::size_t stop = std::min(out.find_first_of(" \t\r\n,", word), end);
    const std::string keyword = lower(std::string_view(out).substr(word, stop - word));
    const bool verbatim = keyword == "ssid" || keyword == "eyebot" || keyword.ends_with("path");
    char quote = '\0';
    for (std::size_t i = start; i < end && !verbatim; ++i) {
      char& c = out[i];
      if (quote != '\0') {
        if (c == quote) quote = '\0';
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '#') {
        break;
      } else if (c == ',') {
        c = ' ';
      }
    }
    start = end + 1;
  }
  return out;
}

}  // namespace eyebridge::files
