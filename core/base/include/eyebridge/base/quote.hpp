#pragma once

#include <string>
#include <string_view>

namespace eyebridge {

/// `text` in quotes for a message: cut to a readable length, control characters as '?'.
std::string in_quotes(std::string_view text);

}  // namespace eyebridge
