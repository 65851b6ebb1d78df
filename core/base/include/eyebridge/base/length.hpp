#pragma once

#include <string_view>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge {

/// Metres of "80mm", "8cm" or "0.08m". Throws ConfigError at `where` for anything else, or less
/// than `least` or more than `most` metres.
double parse_length(std::string_view text, const SourceLocation& where, double least, double most);

}  // namespace eyebridge
