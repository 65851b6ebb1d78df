#include "sim/open_sim.hpp"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "eyebridge/files/load.hpp"
#include "sim/lockstep_clock.hpp"
#include "sim/real_time_clock.hpp"
#include "sim/sim_backend.hpp"

namespace eyebridge::hal {
namespace {

/// An empty room with the robot that was asked for.
files::Scenario empty_room(const Config& config) {
  files::Scenario scenario = files::default_scenario();
  const std::string name = config.text("robot");
  const robot::RobotModel* model = files::builtin_robot(name);
  if (model == nullptr) {
    throw ConfigError(config.value("robot").where,
                      fmt::format("unknown robot '{}', expected a built-in one such as S4", name));
  }
  scenario.models.at(scenario.robots.at(0).model) = *model;
  return scenario;
}

robot::SimulationSettings simulation_settings(const Config& config) {
  robot::SimulationSettings settings;
  // Through the clock's unit, so that the world and the clock agree about what a step is.
  settings.step = to_seconds(from_seconds(config.number("step")));
  settings.seed = static_cast<std::uint64_t>(config.integer("seed"));
  settings.stall_timeout = config.number("stall_timeout");
  return settings;
}

void report(const files::Scenario& scenario, LogSink& log) {
  for (const Warning& warning : scenario.warnings) log.write(Severity::Warning, warning.str());
  if (scenario.robots.size() > 1) {
    log.write(Severity::Info, fmt::format("this program drives robot 1 of {}, the others stand "
                                          "still",
                                          scenario.robots.size()));
  }
  if (scenario.start_paused) {
    log.write(Severity::Info,
              "the world asks to start paused: ignored, as there is no window that "
              "could resume it");
  }
}

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
  report(scenario, context.log);
  const robot::SimulationSettings settings = simulation_settings(context.config);
  std::unique_ptr<SimWorld> world;
  try {
    world = std::make_unique<SimWorld>(std::move(scenario), settings, context.log);
  } catch (const std::invalid_argument& error) {
    throw ConfigError(where, error.what());
  }
  auto clock = make_clock(context.config, from_seconds(settings.step), *world);
  return std::make_unique<SimBackend>(std::move(world), std::move(clock), 0);
}

std::unique_ptr<Backend> open_sim(const BackendUrl& url, const BackendContext& context) {
  const Config& config = context.config;
  if (!url.rest.empty() || !url.options.empty()) {
    throw ConfigError(
        config.value("hal").where,
        fmt::format("found '{}', expected sim alone: --world names the world", config.text("hal")));
  }
  if (!config.is_set("world")) {
    return open_scenario(empty_room(config), {"the empty room"}, context);
  }
  const auto path = config.path("world");
  return open_scenario(files::load_scenario(path, config.text("robot")), {path.string()}, context);
}

}  // namespace eyebridge::hal
