#include "shared/open_only.hpp"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "host/open_host.hpp"
#include "shared/shared_sim.hpp"
#include "sim/open_sim.hpp"
#include "sim/sim_backend.hpp"

namespace eyebridge::hal {
namespace {

/// The world of `scenario`, for its first robot.
std::shared_ptr<SharedSim> open_world(files::Scenario scenario, const SourceLocation& where,
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
    context.log.write(Severity::Info, "robots with \"enters\" are ignored: add --robots all");
  }
  std::shared_ptr<SharedSim> shared;
  try {
    shared = SharedSim::for_one(std::move(scenario), context.config, context.joining, context.log);
  } catch (const std::invalid_argument& error) {
    throw ConfigError(where, error.what());
  }
  begin_report(context.config, *shared->world());
  return shared;
}

std::unique_ptr<Backend> first_robot(const std::shared_ptr<SharedSim>& shared,
                                     const Config& config) {
  return std::make_unique<SimBackend>(shared->world(), shared->clock_of(0), shared->view(), 0,
                                      config.number("supply_voltage"), AtEnd::Stop, shared);
}

}  // namespace

std::unique_ptr<Backend> open_scenario(files::Scenario scenario, const SourceLocation& where,
                                       const BackendContext& context) {
  return first_robot(open_world(std::move(scenario), where, context), context.config);
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
  const auto shared = open_world(configured_scenario(config), where, context);
  return with_host_devices(first_robot(shared, config), context, shared->air());
}

}  // namespace eyebridge::hal
