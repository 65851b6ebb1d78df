#pragma once

#include "eyebridge/files/scenario.hpp"
#include "eyebridge/hal/config.hpp"

namespace eyebridge::hal {

/// Gives the robots of `scenario` the errors that the settings `errors` and `error_scale` want, and
/// their PSDs the tables of the file under `hdt`. Throws ConfigError where they were set.
void apply_error_settings(const Config& config, files::Scenario& scenario);

/// The same for one more type of robot: what is about a robot by its number, or about a device that
/// this type has not, is left out.
void apply_error_settings(const Config& config, robot::RobotModel& model);

}  // namespace eyebridge::hal
