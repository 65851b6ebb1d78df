#pragma once

#include <string>
#include <string_view>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::hal {

/// Throws ConfigError when `text`, named `file`, has something that toml++ 3.3 must not see: a
/// character beyond ASCII outside of quotes and comments (it runs into undefined behaviour there),
/// or a text of several lines, where the same can happen and which no setting needs.
void check_toml_text(std::string_view text, const std::string& file);

}  // namespace eyebridge::hal
