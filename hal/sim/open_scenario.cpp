#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "clock/lockstep_clock.hpp"
#include "clock/real_time_clock.hpp"
#include "clock/time_gate.hpp"
#include "sim/open_sim.hpp"
#include "sim/sim_backend.hpp"
#include "sim/sim_environment.hpp"

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

/// The time of a world, and what a person does to it.
struct WorldTime {
  std::shared_ptr<Clock> clock;
  std::shared_ptr<TimeControl> control;
};

WorldTime make_time(const Config& config, Time step, SimWorld& world, LogSink& log) {
  if (config.boolean("fast")) {
    auto gate = std::make_shared<TimeGate>(step);
    auto clock = std::make_shared<LockstepClock>(step, [&world, gate] {
      gate->pass();
      world.step();
    });
    return {std::move(clock), std::move(gate)};
  }
  auto clock =
      std::make_shared<RealTimeClock>(step, config.number("factor"), [&world] { world.step(); });
  log.write(Severity::Info, "the world's thread has " + clock->priority().str());
  return {clock, clock};
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
  WorldTime time = make_time(context.config, from_seconds(settings.step), *world, context.log);
  auto environment = std::make_shared<SimEnvironment>(*world, std::move(time.control));
  return std::make_unique<SimBackend>(std::move(world), std::move(time.clock),
                                      std::move(environment), 0,
                                      context.config.number("supply_voltage"));
}

}  // namespace eyebridge::hal
