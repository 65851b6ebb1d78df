#pragma once

#include <string>
#include <string_view>

#include "eyebridge/bridges/dbc/database.hpp"

namespace eyebridge::bridges::dbc {

/// Reads `text`, named `file` in messages: UTF-8, or else Windows-1252; any line ends.
///
/// Throws ConfigError, with line and column, for a malformed statement. Sections that say nothing
/// about messages and signals are skipped, known or not.
Database read_dbc(std::string_view text, const std::string& file);

}  // namespace eyebridge::bridges::dbc
