#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge {

/// `text` in single quotes for a message: control characters and what is no UTF-8 as '?', and cut
/// to about `most` bytes, never within a character.
std::string in_quotes(std::string_view text, std::size_t most = 60);

/// `text` for a terminal, whole: control characters other than line ends and tabs, and what is no
/// UTF-8, as \\x1b.
std::string printable(std::string_view text);

/// `text` without the blanks and line ends around it.
std::string_view trimmed(std::string_view text);

/// Levenshtein distance in bytes.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Seconds of "2s", "250ms", "1.5 min", or a bare number of seconds; units us, ms, s, min, h.
/// 0 … 1e9 s. Throws ConfigError at `where`.
double parse_duration(std::string_view text, const SourceLocation& where);

}  // namespace eyebridge
