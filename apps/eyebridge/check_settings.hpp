#pragma once

#include "eyebridge/hal/config.hpp"

namespace eyebridge::apps {

/// Throws ConfigError, with the place the value came from, for every setting that a robot program
/// would fail on later: nothing may have been printed by then. Opens the backend once for that,
/// unless opening it has effects, and makes the folder for results. Whether more than one robot
/// runs a program.
bool check_settings(const hal::Config& config);

}  // namespace eyebridge::apps
