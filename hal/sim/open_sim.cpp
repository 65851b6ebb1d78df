#include "sim/open_sim.hpp"

#include "eyebridge/base/length.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/files/maze_limits.hpp"
#include "eyebridge/hal/world_file.hpp"
#include "sim/error_settings.hpp"

namespace eyebridge::hal {
namespace {

/// An empty room with the robot that was asked for.
files::Scenario empty_room(const Config& config) {
  files::Scenario scenario = files::default_scenario();
  const ConfigValue& robot = config.value("robot");
  scenario.models.at(scenario.robots.at(0).model) = files::named_robot(robot.text, robot.where);
  return scenario;
}

}  // namespace

files::Scenario named_scenario(const Config& config) {
  if (!config.is_set("world")) return empty_room(config);
  const ConfigValue& robot = config.value("robot");
  files::LoadOptions options;
  options.robot = robot.text;
  options.robot_where = robot.where;
  options.places = files::SearchPlaces::of_process(config.program());
  options.reading = config.boolean("strict") ? files::Reading::Strict : files::Reading::Tolerant;
  if (config.is_set("cell")) {
    const ConfigValue& cell = config.value("cell");
    options.cell_where = cell.where;
    options.cell = parse_length(cell.text, cell.where, files::kLeastMazeCell, files::kMostMazeCell);
  }
  return files::load_scenario(find_world(config.value("world"), config.program()), options);
}

files::Scenario configured_scenario(const Config& config) {
  files::Scenario scenario = named_scenario(config);
  apply_error_settings(config, scenario);
  return scenario;
}

robot::SimulationSettings simulation_settings(const Config& config) {
  robot::SimulationSettings settings;
  // Through the clock's unit, so that the world and the clock agree about what a step is.
  settings.step = to_seconds(from_seconds(config.number("step")));
  settings.seed = static_cast<std::uint64_t>(config.integer("seed"));
  settings.stall_timeout = config.number("stall_timeout");
  settings.slides = config.text("contact") == "slide";
  return settings;
}

void report_scenario(const files::Scenario& scenario, LogSink& log) {
  for (const Warning& warning : scenario.warnings)
    log.write(Severity::Warning, warning.where.str() + ": " + warning.text);
}

void begin_report(const Config& config, SimWorld& world) {
  if (!config.is_set("report")) return;
  from_setting(config, "report",
               [&](const std::string& path) { world.report_to(RunReport(path)); });
}

}  // namespace eyebridge::hal
