#pragma once

#include <string>
#include <string_view>

namespace eyebridge {

/// `text` for a file of lines and tabs: \\, \n and \t stand for a backslash, a line end and a tab.
/// Different texts stay different.
std::string escaped(std::string_view text);

/// The text that escaped() made this of.
std::string unescaped(std::string_view text);

/// `word` escaped and in double quotes: words that follow one another can be told apart.
std::string as_one_word(std::string_view word);

}  // namespace eyebridge
