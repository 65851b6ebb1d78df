#include "eyebridge/bridges/io7/help_list.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "opcodes.h"
#include "text.hpp"

namespace eyebridge::bridges::io7 {
namespace {

constexpr std::string_view kQuotes = "'\"`<[(";

bool ends_a_letter(char c) {
  return is_blank(c) || std::string_view(":-=,;.)>]'\"`|").find(c) != std::string_view::npos;
}

/// The line without a bullet or a number: "* m", "- m", "3) m", "12. m".
std::string_view without_bullet(std::string_view line) {
  if (line.size() > 2 && (line[0] == '*' || line[0] == '-') && is_blank(line[1])) {
    return trim(line.substr(1));
  }
  std::size_t digits = 0;
  while (digits < line.size() && line[digits] >= '0' && line[digits] <= '9') ++digits;
  if (digits > 0 && digits + 1 < line.size() && (line[digits] == ')' || line[digits] == '.')) {
    return trim(line.substr(digits + 1));
  }
  return line;
}

/// The letter that `line` starts with; 0 when it starts with a word or anything else.
char leading_letter(std::string_view line) {
  line = without_bullet(trim(line));
  if (line.size() > 1 && kQuotes.find(line.front()) != std::string_view::npos) {
    line.remove_prefix(1);
  }
  if (line.empty() || !is_letter(line.front())) return 0;
  return line.size() == 1 || ends_a_letter(line[1]) ? line.front() : '\0';
}

/// Adds the letters of a line like "h O m M" or "h,O,m,M"; false when it has anything else.
bool add_single_letters(std::string_view line, LetterSet& letters) {
  LetterSet found;
  const auto between = [](char c) { return is_blank(c) || c == ',' || c == ';' || c == '|'; };
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (between(line[i])) continue;
    if (!is_letter(line[i]) || (i + 1 < line.size() && !between(line[i + 1]))) return false;
    found.insert(line[i]);
  }
  letters = found;
  return true;
}

}  // namespace

Result<LetterSet> parse_help(std::string_view text) {
  const bool is_text = std::all_of(text.begin(), text.end(), [](char c) {
    // Bytes above 127 may be a comment in some other script; letters are 7-bit.
    return is_printable(c) || is_blank(c) || is_line_end(c) || static_cast<unsigned char>(c) >= 128;
  });
  LetterSet letters;
  std::string_view only_line;
  int lines = 0;
  for (std::string_view rest = text; is_text && !rest.empty();) {
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    const std::string_view line = trim(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    // A line that is no more than the echo of the request says nothing about the list's form.
    if (line.empty() || (line.size() == 1 && line[0] == IO7_HELP && lines == 0)) continue;
    only_line = line;
    ++lines;
    if (const char letter = leading_letter(line); letter != 0) letters.insert(letter);
  }
  if (lines == 1) add_single_letters(only_line, letters);
  if (!letters.has(IO7_HELP) && !letters.has(IO7_VERSION)) {
    return fail(Errc::Corrupt, "expected a list of command letters, found " + quoted(text));
  }
  letters.insert(IO7_HELP);  // It was answered, whether or not the list repeats it.
  return letters;
}

}  // namespace eyebridge::bridges::io7
