#pragma once

#include <string>
#include <string_view>

#include "eyebridge/base/text.hpp"
#include "eyebridge/hal/config.hpp"

namespace eyebridge::hal {

// Each reads the whole of `text`, blanks around it aside, or throws ConfigError at `where`.

bool parse_boolean(std::string_view text, const SourceLocation& where);
long long parse_integer(std::string_view text, const SourceLocation& where);
/// Finite.
double parse_number(std::string_view text, const SourceLocation& where);

/// Throws ConfigError unless `value` is what `setting` allows.
void check_value(const Setting& setting, const ConfigValue& value);

/// The error for a key that is in no row of settings(): names the nearest one.
ConfigError unknown_key(std::string_view what, std::string_view key, const SourceLocation& where);

}  // namespace eyebridge::hal
