#pragma once

#include "eyebridge/files/scenario.hpp"
#include "eyebridge/hal/config.hpp"
#include "eyebridge/robot/simulation.hpp"
#include "sim/sim_world.hpp"

namespace eyebridge::hal {

/// The scenario that the configuration names, or an empty room; with the errors that it sets.
files::Scenario configured_scenario(const Config& config);

/// The same without the errors that it sets, which are rules for the robots that there are.
files::Scenario named_scenario(const Config& config);

/// How the configuration wants it simulated.
robot::SimulationSettings simulation_settings(const Config& config);

/// Lets `world` keep the report that the configuration wants, if it wants one. Throws ConfigError
/// when its file cannot be written.
void begin_report(const Config& config, SimWorld& world);

/// Tells `log` what is odd about the scenario.
void report_scenario(const files::Scenario& scenario, LogSink& log);

}  // namespace eyebridge::hal
