#pragma once

#include <string>
#include <string_view>

namespace eyebridge {

/// `text` for a file of lines and tabs: \\, \n and \t stand for a backslash, a line end and a tab.
/// Different texts stay different.
std::string escaped(std::string_view text);

/// The text that escaped() made this of.
std::string unescaped(std::string_view text);

}  // namespace eyebridge
