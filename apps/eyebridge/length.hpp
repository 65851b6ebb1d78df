#pragma once

#include <string>

namespace eyebridge::apps {

/// Metres of "80mm", "8cm" or "0.08m". Throws ConfigError at `flag` for anything else, or less than
/// `least` or more than `most` metres.
double parse_length(const std::string& text, const char* flag, double least, double most);

}  // namespace eyebridge::apps
