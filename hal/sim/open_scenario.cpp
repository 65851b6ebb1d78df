#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "clock/lockstep_clock.hpp"
#include "clock/real_time_clock.hpp"
#include "sim/open_sim.hpp"
#include "sim/sim_backend.hpp"

namespace eyebridge::hal {

robot::SimulationSettings simulation_settings(const Config& config) {
  robot::SimulationSettings settings;
  // Through the clock's unit, so that the world and the clock agree about what a step is.
  settings.step = to_seconds(from_seconds(config.number("step")));
  settings.seed = static_cast<std::uint64_t>(config.integer("seed"));
  settings.stall_timeout = config.number("stall_timeout");
  return settings;
}

void report_scenario(const files::Scenario& scenario, LogSink& log) {
  for (const Warning& warning : scenario.warnings) log.write(Severity::Warning, warning.str());
  if (scenario.start_paused) {
    log.write(Severity::Info,
              "the world asks to start paused: ignored, as there is no window that "
              "could resume it");
  }
}

void begin_report(const Config& config, SimWorld& world) {
  if (!config.is_set("report")) return;
  try {
    world.report_to(RunReport(config.path("report")));
  } catch (const ConfigError& error) {
    throw error_in(config.value("report"), error);
  }
}

namespace {

std::unique_ptr<Clock> make_clock(const Config& config, Time step, SimWorld& world) {
  if (config.boolean("fast")) {
    return std::make_unique<LockstepClock>(step, [&world] { world.step(); });
  }
  return std::make_unique<RealTimeClock>(step, config.number("factor"), [&world] { world.step(); });
}

}  // namespace

std::unique_ptr<Backend> open_scenario(files::Scenario scenario, const SourceLocation& where,
                                       const BackendContext& context) {
  if (scenario.robots.empty()) {
    throw ConfigError(where, "found no robot, expected at least one");
  }
  report_scenario(scenario, context.log);
  if (scenario.robots.size() > 1) {
    context.log.write(Severity::Info,
                      fmt::format("this program drives robot 1 of {}, the others stand still; all "
                                  "have one with --robots all",
                                  scenario.robots.size()));
  }
  if (!scenario.newcomers.empty()) {
    context.log.write(Severity::Info, "robots that enter later do so with --robots all only");
  }
  const robot::SimulationSettings settings = simulation_settings(context.config);
  std::unique_ptr<SimWorld> world;
  try {
    world = std::make_unique<SimWorld>(std::move(scenario), settings, context.log);
  } catch (const std::invalid_argument& error) {
    throw ConfigError(where, error.what());
  }
  begin_report(context.config, *world);
  auto clock = make_clock(context.config, from_seconds(settings.step), *world);
  return std::make_unique<SimBackend>(std::move(world), std::move(clock), 0,
                                      context.config.number("supply_voltage"));
}

}  // namespace eyebridge::hal
