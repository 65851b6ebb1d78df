#pragma once

#include <filesystem>
#include <optional>

#include "eyebridge/files/load.hpp"
#include "eyebridge/files/readers.hpp"
#include "text.hpp"

namespace eyebridge::files {

/// Reads the world or maze at `path` into `scenario`: its world, start places and warnings. A floor
/// texture is looked for beside `path`, then where find_file() looks; what is found becomes an
/// absolute path, anything else stays as written. Throws ConfigError.
void load_ground(const std::filesystem::path& path, GroundKind kind, Scenario& scenario,
                 const LoadOptions& options);

/// Reads "water MM" of a world or a simulation into `water`, metres. Throws ConfigError, also where
/// `water` is known already.
void read_water(const Statement& s, std::optional<double>& water);

}  // namespace eyebridge::files
