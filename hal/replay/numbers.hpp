#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "calls/interceptor.hpp"

namespace eyebridge::hal {

/// "0.3 0 -1.5": the shortest decimals that read back as the same doubles.
std::string write_numbers(const Values& values);

/// The numbers of such a text; nothing when something else is in it.
std::optional<Values> read_numbers(std::string_view text);

}  // namespace eyebridge::hal
