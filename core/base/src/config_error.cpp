#include "eyebridge/base/config_error.hpp"

#include <algorithm>

namespace eyebridge {

std::string SourceLocation::str() const {
  std::string out = file;
  std::ranges::replace(out, '\n', '?');  // a name must not look like another message
  if (line > 0) out += ':' + std::to_string(line);
  if (line > 0 && column > 0) out += ':' + std::to_string(column);
  return out;
}

ConfigError::ConfigError(SourceLocation where, const std::string& text)
    : std::runtime_error(where.file.empty() ? text : where.str() + ": " + text),
      where_(std::move(where)),
      text_(text) {}

std::string Warning::str() const { return where.str() + ": warning: " + text; }

}  // namespace eyebridge
