#pragma once

#include <string>
#include <string_view>

#include "eyebridge/files/error_rules.hpp"
#include "eyebridge/files/load.hpp"

namespace eyebridge::files {

/// Walls around 2 m x 2 m.
world::WorldModel empty_room();

/// Fills `scenario` from the `.sim` file `name` with content `text`. Returns its rules about
/// errors, for when all robots are placed. Throws ConfigError.
std::vector<ErrorRule> load_sim(std::string_view text, const std::string& name, Scenario& scenario,
                                const LoadOptions& options);

}  // namespace eyebridge::files
