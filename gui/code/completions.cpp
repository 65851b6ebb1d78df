#include "code/completions.hpp"

#include <algorithm>
#include <cctype>
#include <string>

namespace eyebridge::gui {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Where the comment, string or character that begins at `at` ends; `at` where none begins.
std::size_t after_quiet(std::string_view text, std::size_t at) {
  const auto past = [&](std::string_view end) {
    const std::size_t found = text.find(end, at + 2);
    return found == text.npos ? text.size() : found + end.size();
  };
  if (text.substr(at).starts_with("//")) return past("\n");
  if (text.substr(at).starts_with("/*")) return past("*/");
  if (text[at] != '"' && text[at] != '\'') return at;
  std::size_t i = at + 1;
  while (i < text.size() && text[i] != text[at] && text[i] != '\n') i += text[i] == '\\' ? 2 : 1;
  return std::min(i + 1, text.size());
}

/// Calls `see` with every name that a parenthesis follows.
template <class See>
void for_each_call(std::string_view text, See see) {
  std::size_t at = 0;
  while (at < text.size()) {
    if (const std::size_t end = after_quiet(text, at); end != at) {
      at = end;
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && is_word(text[end])) ++end;
    if (end == at) {
      ++at;
      continue;
    }
    const std::size_t next = text.find_first_not_of(" \t\r\n", end);
    if (next != text.npos && text[next] == '(') see(text.substr(at, end - at));
    at = end;
  }
}

bool includes_classic_header(std::string_view program) {
  static constexpr std::string_view kHeaders[] = {"hdt.h", "hdt_sem.h", "irtv.h",
                                                  "classic/eyebot.h"};
  std::size_t at = 0;
  while (at < program.size()) {
    const std::size_t end = std::min(program.find('\n', at), program.size());
    std::string_view line = program.substr(at, end - at);
    at = end + 1;
    std::string packed;
    for (const char c : line) {
      if (c != ' ' && c != '\t') packed += c;
    }
    if (!packed.starts_with("#include")) continue;
    const auto is_named = [&](std::string_view header) {
      const std::size_t place = packed.find(header);
      if (place == packed.npos || place == 0) return false;
      const char before = packed[place - 1];
      const char after = place + header.size() < packed.size() ? packed[place + header.size()] : 0;
      return (before == '"' || before == '<' || before == '/') && (after == '"' || after == '>');
    };
    if (std::ranges::any_of(kHeaders, is_named)) return true;
  }
  return false;
}

bool is_function(Api api, std::string_view name) {
  const Completion* const found = find_completion(api, name);
  return found != nullptr && found->kind == Completion::Kind::Function;
}

}  // namespace

const Completion* find_completion(Api api, std::string_view name) {
  const auto all = completions(api);
  const auto found = std::ranges::lower_bound(
      all, name, {}, [](const Completion& c) { return std::string_view(c.name); });
  return found != all.end() && name == found->name ? &*found : nullptr;
}

bool is_classic(std::string_view program) {
  if (includes_classic_header(program)) return true;
  int only_classic = 0;
  int only_robios7 = 0;
  for_each_call(program, [&](std::string_view name) {
    const bool in_classic = is_function(Api::Classic, name);
    const bool in_robios7 = is_function(Api::Robios7, name);
    if (in_classic && !in_robios7) ++only_classic;
    if (in_robios7 && !in_classic) ++only_robios7;
  });
  return only_classic > only_robios7;
}

}  // namespace eyebridge::gui
