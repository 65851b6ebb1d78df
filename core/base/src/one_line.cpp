#include "eyebridge/base/one_line.hpp"

namespace eyebridge {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\' || c == '\n' || c == '\t') out += '\\';
    out += c == '\n' ? 'n' : c == '\t' ? 't' : c;
  }
  return out;
}

std::string unescaped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = text[i] == '\\' && i + 1 < text.size();
    const char c = text[begins ? ++i : i];
    out += begins && c == 'n' ? '\n' : begins && c == 't' ? '\t' : c;
  }
  return out;
}

std::string as_one_word(std::string_view word) {
  std::string out = "\"";
  for (const char c : escaped(word)) {
    if (c == '"') out += '\\';
    out += c;
  }
  return out + '"';
}

}  // namespace eyebridge
