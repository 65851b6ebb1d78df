#pragma once

#include <string>
#include <string_view>

namespace eyebridge {

/// Throws ConfigError at the first line of `toml` that opens a table, "[" or "[[", with what begins
/// no name. To be asked before toml++ 3.3 reads the text: it takes for granted that a name begins
/// there, and what it does else is undefined. So, too, where a line has a thousand dots and more:
/// it goes as deep as a name has parts.
void check_table_names(std::string_view toml, const std::string& file);

}  // namespace eyebridge
