#include "dbc_scanner.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

#include "eyebridge/base/text.hpp"

namespace eyebridge::bridges::dbc {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";
constexpr std::string_view kPunctuation = ":;,|@()[]\"";

bool is_digit(char character) { return character >= '0' && character <= '9'; }
bool is_blank(char character) { return kBlanks.find(character) != std::string_view::npos; }

bool is_part_of_word(char character) {
  return character != '\n' && !is_blank(character) &&
         kPunctuation.find(character) == std::string_view::npos;
}

}  // namespace

Scanner::Scanner(std::string_view text, std::string file)
    : text_(text), file_(std::move(file)), lines_{0} {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') lines_.push_back(i + 1);
  }
}

void Scanner::skip_blanks() {
  while (at_ < text_.size() && (is_blank(text_[at_]) || (crosses_lines_ && text_[at_] == '\n'))) {
    ++at_;
  }
}

bool Scanner::at_end() {
  skip_blanks();
  return at_ >= text_.size();
}

bool Scanner::at_line_end() {
  skip_blanks();
  return at_ >= text_.size() || text_[at_] == '\n';
}

char Scanner::peek() { return at_line_end() ? '\0' : text_[at_]; }

bool Scanner::take(char wanted) {
  if (at_end() || text_[at_] != wanted) return false;
  ++at_;
  return true;
}

void Scanner::expect(char wanted) {
  if (!take(wanted)) refuse(std::string("'") + wanted + "'");
}

std::string_view Scanner::peek_word() {
  skip_blanks();
  std::size_t end = at_;
  while (end < text_.size() && is_part_of_word(text_[end])) ++end;
  return text_.substr(at_, end - at_);
}

std::string_view Scanner::word(std::string_view expected) {
  const std::string_view found = peek_word();
  if (found.empty()) refuse(expected);
  at_ += found.size();
  return found;
}

std::uint64_t Scanner::whole(std::string_view expected, std::uint64_t most) {
  skip_blanks();
  std::size_t end = at_;
  while (end < text_.size() && is_digit(text_[end])) ++end;
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text_.data() + at_, text_.data() + end, value);
  if (error != std::errc{} || value > most) refuse(expected);
  at_ = end;
  return value;
}

double Scanner::number(std::string_view expected) {
  skip_blanks();
  std::size_t begin = at_;
  if (begin < text_.size() && text_[begin] == '+') ++begin;
  std::size_t end = begin;
  constexpr std::string_view kParts = "+-.eE";
  while (end < text_.size() &&
         (is_digit(text_[end]) || kParts.find(text_[end]) != std::string_view::npos)) {
    ++end;
  }
  double value = 0;
  const auto [stop, error] = std::from_chars(text_.data() + begin, text_.data() + end, value);
  if (error == std::errc::result_out_of_range) {
    // Too large, or too small for any but 0.
    const bool is_tiny = text_.substr(begin, end - begin).find("e-") != std::string_view::npos ||
                         text_.substr(begin, end - begin).find("E-") != std::string_view::npos;
    value = is_tiny ? 0.0 : std::numeric_limits<double>::max();
    if (text_[begin] == '-') value = -value;
  } else if (error != std::errc{} || stop != text_.data() + end) {
    refuse(expected);
  }
  at_ = end;
  return value;
}

std::string Scanner::text(std::string_view expected) {
  skip_blanks();
  if (at_ >= text_.size() || text_[at_] != '"') refuse(expected);
  const std::size_t begin = at_++;
  std::string out;
  for (; at_ < text_.size() && text_[at_] != '"'; ++at_) {
    if (text_[at_] == '\\' && at_ + 1 < text_.size() &&
        (text_[at_ + 1] == '"' || text_[at_ + 1] == '\\')) {
      ++at_;
    }
    if (text_[at_] != '\r') out += text_[at_];
  }
  if (at_ >= text_.size()) {
    refuse_at(begin, "found a text without an end, expected another '\"'");
  }
  ++at_;
  return out;
}

void Scanner::skip_line() {
  at_ = std::min(text_.find('\n', at_), text_.size());
  if (at_ < text_.size()) ++at_;
}

bool Scanner::begins_statement(std::size_t position) const {
  while (position < text_.size() && is_blank(text_[position])) ++position;
  std::size_t end = position;
  while (end < text_.size() && ((text_[end] >= 'A' && text_[end] <= 'Z') || text_[end] == '_')) {
    ++end;
  }
  const std::string_view found = text_.substr(position, end - position);
  return found == "VERSION" || (found.size() > 2 && found.back() == '_');
}

void Scanner::skip_statement() {
  bool in_text = false;
  for (; at_ < text_.size(); ++at_) {
    const char character = text_[at_];
    if (in_text) {
      if (character == '\\') ++at_;
      if (character == '"') in_text = false;
    } else if (character == '"') {
      in_text = true;
    } else if (character == ';') {
      ++at_;
      return;
    } else if (character == '\n' && begins_statement(at_ + 1)) {
      return;
    }
  }
  at_ = std::min(at_, text_.size());
}

void Scanner::end_statement() {
  if (take(';') || at_end()) return;
  // Some files leave it out: a new line is an end, too.
  const std::size_t last = text_.find_last_not_of(" \t\r\v\f\n", at_ - 1);
  if (text_.substr(last, at_ - last).find('\n') == std::string_view::npos) refuse("';'");
}

SourceLocation Scanner::place(std::size_t position) const {
  const auto next = std::ranges::upper_bound(lines_, position);
  const auto line = next - lines_.begin();
  const std::size_t column = position - *(next - 1) + 1;
  return {file_, static_cast<int>(line), static_cast<int>(column)};
}

void Scanner::refuse(std::string_view expected) {
  skip_blanks();
  std::string found = "the end of the file";
  if (at_ < text_.size()) {
    const std::string_view next = peek_word();
    found = text_[at_] == '\n' ? "the end of the line"
                               : in_quotes(next.empty() ? text_.substr(at_, 1) : next);
  }
  refuse_at(at_, "found " + found + ", expected " + std::string(expected));
}

void Scanner::refuse_at(std::size_t position, const std::string& text) const {
  throw ConfigError(place(position), text);
}

}  // namespace eyebridge::bridges::dbc
