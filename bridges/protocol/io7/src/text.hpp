#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace eyebridge::bridges::io7 {

constexpr bool is_printable(char c) { return c >= 0x20 && c < 0x7F; }
constexpr bool is_line_end(char c) { return c == '\r' || c == '\n'; }
constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// `text` without blanks and line ends around it.
std::string_view trim(std::string_view text);

/// What follows the last ':' or '=' of `line`, trimmed; all of it when there is none.
std::string_view after_label(std::string_view line);

/// Reads exactly `out.size()` decimal integers, separated by blanks or commas, and nothing else.
bool read_integers(std::string_view text, std::span<int> out);

/// `bytes` for a message: printable as they are, the rest as \xNN; cut after 40.
std::string quoted(std::string_view bytes);

}  // namespace eyebridge::bridges::io7
