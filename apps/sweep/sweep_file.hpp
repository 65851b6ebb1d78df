#pragma once

#include <string>
#include <string_view>

#include "sweep/plan.hpp"

namespace eyebridge::apps {

/// Reads a sweep file, named `file` in messages: TOML whose keys are settings (`world`, `seed`, as
/// in eyebridge.toml, but each may be a list of values), `program` (a text or a list),
/// `arguments` (a list of texts), `results`, `wall_limit`, `jobs`, and the tables `[environment]`
/// and `[parameters]` (texts, numbers, or lists of them). `seed` may be a range: "1..20".
/// Relative paths (programs with a slash, and settings that are paths) are taken from the file's
/// folder. Throws ConfigError.
SweepPlan read_sweep(std::string_view text, const std::string& file);

}  // namespace eyebridge::apps
