#pragma once

#include "eyebridge/files/scenario.hpp"
#include "eyebridge/hal/config.hpp"

namespace eyebridge::hal {

/// Gives the robots of `scenario` the errors that the settings `errors` and `error_scale` want, and
/// their PSDs the tables of the file under `hdt`. Throws ConfigError where they were set.
void apply_error_settings(const Config& config, files::Scenario& scenario);

}  // namespace eyebridge::hal
