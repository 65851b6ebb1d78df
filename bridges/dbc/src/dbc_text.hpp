#pragma once

#include <string>
#include <string_view>

namespace eyebridge::bridges::dbc {

/// `text` as UTF-8: as it is where it is that already, else read as Windows-1252. Without a byte
/// order mark.
std::string to_utf8(std::string_view text);

}  // namespace eyebridge::bridges::dbc
