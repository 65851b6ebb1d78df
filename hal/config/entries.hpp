#pragma once

#include <string_view>
#include <vector>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::hal {

/// One of the entries of a text like "psd:1 lose; all delay 20ms".
struct Entry {
  std::string_view text;
  SourceLocation where;
};

/// What stands between the ';' of `text`, empty entries left out. They are at `where`; where that
/// has no line, in line 1 at their column.
std::vector<Entry> split_entries(std::string_view text, const SourceLocation& where);

}  // namespace eyebridge::hal
