#pragma once

#include <optional>
#include <string>

#include "eyebridge/files/readers.hpp"
#include "text.hpp"

namespace eyebridge::files {

/// The keywords of lines that say how an object moves by itself, beside its path.
bool is_motion_trait(std::string_view keyword);

/// Whether it makes an object move by itself, and so takes the place of what did.
bool begins_way(std::string_view keyword);

/// Reads "speeds", "waits", "acceleration" (of `traits.path`), "yields", "follow", "flee" or
/// "wander" into `traits`. Throws ConfigError for numbers that cannot be, and for what goes with
/// none of what `traits` has.
void read_motion_trait(const Statement& s, ObjectTraits& traits);

/// The lines that read_motion_trait() makes these of.
std::string motion_lines(const std::optional<world::Path>& path,
                         const std::optional<world::Reaction>& reaction, double yields_within);

}  // namespace eyebridge::files
