#include "text.hpp"

#include <charconv>

namespace eyebridge::bridges::io7 {

std::string_view trim(std::string_view text) {
  const auto outer = [](char c) { return is_blank(c) || is_line_end(c); };
  while (!text.empty() && outer(text.front())) text.remove_prefix(1);
  while (!text.empty() && outer(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view after_label(std::string_view line) {
  const std::size_t label = line.find_last_of(":=");
  return trim(label == std::string_view::npos ? line : line.substr(label + 1));
}

bool read_integers(std::string_view text, std::span<int> out) {
  text = trim(text);
  for (int& value : out) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{}) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (!text.empty() && !is_blank(text.front()) && text.front() != ',') return false;
    while (!text.empty() && (is_blank(text.front()) || text.front() == ',')) text.remove_prefix(1);
  }
  return text.empty();
}

std::string quoted(std::string_view bytes) {
  constexpr std::size_t kLongest = 40;
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string out = "\"";
  for (const char c : bytes.substr(0, kLongest)) {
    if (is_printable(c)) {
      out += c;
    } else {
      const auto code = static_cast<unsigned char>(c);
      out += "\\x";
      out += kDigits[code / 16];
      out += kDigits[code % 16];
    }
  }
  out += bytes.size() > kLongest ? "\"…" : "\"";
  return out;
}

}  // namespace eyebridge::bridges::io7
