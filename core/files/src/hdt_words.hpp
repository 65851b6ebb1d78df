#pragma once

#include <string>
#include <string_view>

#include "text.hpp"

namespace eyebridge::files {

/// Token `i` as a hexadecimal number of at most 31 bits, with or without 0x; throws ConfigError.
int hex(const Statement& s, std::size_t i, std::string_view what);

/// An HDT whose words are separated by blanks only, every byte in its place: commas become blanks,
/// but for those in quotes, comments, names and paths.
std::string commas_blanked(std::string_view text);

}  // namespace eyebridge::files
