#pragma once

#include <string>
#include <string_view>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::hal {

// toml++ 3.3 runs into undefined behaviour when it meets certain characters beyond ASCII outside of
// quotes. It gets to see ASCII only: every other byte, and '~', is written as '~' and two digits.

/// `text` in ASCII. Throws ConfigError when it spells '~' as \u007E, which could not be told apart.
std::string to_ascii(std::string_view text, const std::string& file);

/// What `ascii`, or a piece of it, was made from.
std::string from_ascii(std::string_view ascii);

/// The place in the text that `where` in `ascii` stands for: columns count characters.
SourceLocation original_place(std::string_view ascii, SourceLocation where);

}  // namespace eyebridge::hal
