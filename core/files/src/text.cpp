#include "text.hpp"

#include <algorithm>

namespace eyebridge::files {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

}  // namespace

void check_text(std::string_view text, const std::string& file) {
  int line = 1;
  std::size_t start = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const int column = static_cast<int>(i - start) + 1;
    if (byte == '\n') {
      ++line;
      start = i + 1;
    } else if ((byte < 0x20 && !is_blank(text[i]) && byte != 0x1A) || byte == 0x7F) {
      throw ConfigError({file, line, column},
                        "byte " + std::to_string(byte) + " found: expected a text file");
    } else if (i - start >= kMaxLine) {
      throw ConfigError({file, line, column}, "line is too long: expected at most " +
                                                  std::to_string(kMaxLine) + " bytes");
    }
  }
}

std::string_view without_bom(std::string_view text) {
  return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

std::string lower(std::string_view word) {
  std::string out(word);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates) {
  if (word.size() > 40) return {};
  const std::string wanted = lower(word);
  std::string_view best;
  std::size_t best_distance = 3;
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = edit_distance(wanted, lower(candidate));
    // Two edits turn any short word into any other: they must leave most of it standing.
    if (distance < best_distance && 2 * distance < candidate.size()) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string one_of(std::span<const std::string_view> words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? " or " : ", ";
    out += words[i];
  }
  return out;
}

void Warnings::add(int line, int column, std::string text) {
  if (++count_ > kMost) {
    if (count_ == kMost + 1) out_.push_back({{file_, line, column}, "more oddities, not listed"});
    return;
  }
  out_.push_back({{file_, line, column}, std::move(text)});
}

StatementReader::StatementReader(std::string_view text, const std::string& file)
    : rest_(without_bom(text)), file_(file) {
  check_text(rest_, file);
}

bool StatementReader::next(Statement& statement) {
  while (!rest_.empty()) {
    const std::size_t end = rest_.find('\n');
    const std::string_view line = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
    ++line_;
    statement.file_ = &file_;
    statement.line_ = line_;
    statement.tokens_.clear();
    std::size_t i = 0;
    while (i < line.size()) {
      const char c = line[i];
      const int column = static_cast<int>(i) + 1;
      if (is_blank(c) || c == 0x1A) {  // 0x1A: DOS end of file
        ++i;
      } else if (c == '#' || c == ';') {
        break;
      } else if (c == '"' || c == '\'') {
        const std::size_t close = line.find(c, i + 1);
        if (close == std::string_view::npos) {
          throw ConfigError({file_, line_, column}, std::string("quote ") + c +
                                                        " is not closed: expected another one on "
                                                        "this line");
        }
        statement.tokens_.push_back({line.substr(i + 1, close - i - 1), column, true});
        i = close + 1;
      } else {
        std::size_t stop = i;
        while (stop < line.size() && !is_blank(line[stop]) && line[stop] != '#' &&
               line[stop] != ';' && line[stop] != 0x1A) {
          ++stop;
        }
        statement.tokens_.push_back({line.substr(i, stop - i), column, false});
        i = stop;
      }
    }
    statement.raw_ = line.substr(0, i);
    if (!statement.tokens_.empty()) return true;
  }
  return false;
}

}  // namespace eyebridge::files
