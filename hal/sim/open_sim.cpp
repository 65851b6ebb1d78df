#include "sim/open_sim.hpp"

#include <utility>

#include <fmt/format.h>

#include "eyebridge/files/load.hpp"
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
  const auto& robot = config.value("robot");
  return files::load_scenario(config.path("world"), robot.text, {}, robot.where);
}

files::Scenario configured_scenario(const Config& config) {
  files::Scenario scenario = named_scenario(config);
  apply_error_settings(config, scenario);
  return scenario;
}

std::unique_ptr<Backend> open_sim(const BackendUrl& url, const BackendContext& context) {
  const Config& config = context.config;
  if (!url.rest.empty() || !url.options.empty()) {
    throw ConfigError(
        config.value("hal").where,
        fmt::format("found '{}', expected sim alone: --world names the world", config.text("hal")));
  }
  const SourceLocation where{config.is_set("world") ? config.path("world").string()
                                                    : "the empty room"};
  return open_scenario(configured_scenario(config), where, context);
}

}  // namespace eyebridge::hal
