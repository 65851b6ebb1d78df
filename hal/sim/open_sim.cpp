#include "sim/open_sim.hpp"

#include <utility>

#include <fmt/format.h>

#include "eyebridge/files/load.hpp"

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
  const auto& robot = config.value("robot");
  return open_scenario(files::load_scenario(path, robot.text, {}, robot.where), {path.string()},
                       context);
}

}  // namespace eyebridge::hal
