#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eyebridge::robios {

/// `text` in Latin-1, one byte a character. Bytes that are not UTF-8 are taken as Latin-1 already
/// (programs of 1998 to 2025 hold both); characters beyond Latin-1 become '?'.
std::string to_latin1(std::string_view text);

/// The lines of `text` between '\n's, in Latin-1. At least one.
std::vector<std::string> latin1_lines(std::string_view text);

/// Latin-1 as UTF-8.
std::string to_utf8(std::string_view latin1);

}  // namespace eyebridge::robios
