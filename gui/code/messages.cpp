#include "code/messages.hpp"

#include <algorithm>
#include <charconv>

namespace eyebridge::gui {
namespace {

// Nobody reads a file with more lines, and numbers beyond are no line numbers.
constexpr int kMostLines = 100'000'000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The number that begins at `at`, which moves behind it; 0 when there is none or it is no line.
int number_at(std::string_view text, std::size_t& at) {
  std::size_t end = at;
  while (end < text.size() && is_digit(text[end])) ++end;
  int value = 0;
  const auto done = std::from_chars(text.data() + at, text.data() + end, value);
  if (end == at || done.ec != std::errc() || value > kMostLines) return 0;
  at = end;
  return value;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// "12:30" is a time, "http://host:80" an address; a file has a folder or an extension.
bool looks_like_file(std::string_view name) {
  if (name.empty() || name.find("://") != name.npos) return false;
  // What compilers call what is no file.
  if (name.front() == '<' || name.front() == '(') return false;
  if (name.find('/') != name.npos) return name.back() != '/';
  const std::size_t dot = name.rfind('.');
  return dot != name.npos && dot + 1 < name.size() && dot > 0 && is_letter(name[dot + 1]);
}

/// Where the file name that ends at `end` begins: behind the words before it.
std::size_t begin_of_file(std::string_view text, std::size_t end) {
  const std::string_view before = text.substr(0, end);
  std::size_t begin = before.find_first_not_of(" \t");
  if (begin == before.npos) return end;
  for (const std::string_view words : {": ", "from ", "(", " at ", " in "}) {
    const std::size_t found = before.rfind(words);
    if (found != before.npos && found + words.size() <= end) {
      begin = std::max(begin, found + words.size());
    }
  }
  begin = std::min(before.find_first_not_of(" \t", begin), end);
  if (begin < end && text[begin] == '/') return begin;
  const std::size_t blank = before.find_last_of(" \t");
  return blank == before.npos ? begin : std::max(begin, blank + 1);
}

Message::Severity severity_of(std::string_view text) {
  const std::string_view said = trimmed(text);
  if (said.starts_with("note") || said.starts_with("In ") || said.starts_with("from ")) {
    return Message::Severity::Note;
  }
  if (said.starts_with("warning")) return Message::Severity::Warning;
  return Message::Severity::Error;
}

/// `  File "prog.py", line 12, in main`
std::optional<Message> python_message(std::string_view output) {
  constexpr std::string_view kBefore = "File \"";
  constexpr std::string_view kBetween = "\", line ";
  const std::size_t begin = output.find_first_not_of(" \t|+");
  if (begin == output.npos || !output.substr(begin).starts_with(kBefore)) return {};
  const std::size_t file = begin + kBefore.size();
  const std::size_t quote = output.find(kBetween, file);
  if (quote == output.npos || quote == file || output[file] == '<') return {};
  std::size_t at = quote + kBetween.size();
  Message message;
  message.line = number_at(output, at);
  if (message.line == 0) return {};
  message.severity = Message::Severity::Error;
  message.file = output.substr(file, quote - file);
  message.text = trimmed(output.substr(at));
  message.begin = begin;
  message.end = at;
  return message;
}

/// The place whose file name ends at the colon at `colon`.
std::optional<Message> message_at(std::string_view output, std::size_t colon) {
  Message message;
  message.begin = begin_of_file(output, colon);
  const std::string_view file = output.substr(message.begin, colon - message.begin);
  if (!looks_like_file(file)) return {};
  std::size_t at = colon + 1;
  message.line = number_at(output, at);
  if (message.line == 0) return {};
  message.end = at;
  if (at < output.size() && output[at] == ':') {
    std::size_t column = at + 1;
    message.column = number_at(output, column);
    if (message.column != 0) message.end = column;
  }
  const std::string_view rest = output.substr(message.end);
  // "a.c:12x" is no place.
  if (!rest.empty() && (is_letter(rest.front()) || is_digit(rest.front()))) return {};
  message.file = file;
  message.text = trimmed(rest.substr(std::min(rest.find_first_not_of(":,"), rest.size())));
  const std::string_view before = trimmed(output.substr(0, message.begin));
  message.severity = before.ends_with("from") ? Message::Severity::Note : severity_of(message.text);
  return message;
}

}  // namespace

std::optional<Message> find_message(std::string_view output) {
  if (auto python = python_message(output)) return python;
  std::size_t colon = 0;
  while ((colon = output.find(':', colon)) != output.npos) {
    if (colon + 1 < output.size() && is_digit(output[colon + 1])) {
      if (auto message = message_at(output, colon)) return message;
    }
    ++colon;
  }
  return {};
}

}  // namespace eyebridge::gui
