#include "shared/shared_sim.hpp"

#include <charconv>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "clock/round_clock.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/files/load.hpp"
#include "sim/error_settings.hpp"
#include "sim/open_sim.hpp"

namespace eyebridge::hal {
namespace {

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kMostRobots = 100'000;

/// What `robots` says: a number, or kAll.
std::size_t count_in(const ConfigValue& value) {
  if (value.text == "all") return kAll;
  std::size_t count = 0;
  const char* const end = value.text.data() + value.text.size();
  const auto [stop, error] = std::from_chars(value.text.data(), end, count);
  if (error == std::errc() && stop == end && count >= 1 && count <= kMostRobots) return count;
  throw ConfigError(value.where, fmt::format("found {}, expected 1 … {} robots, or all",
                                             in_quotes(value.text), kMostRobots));
}

/// What only a robot that is alone can have.
void check_alone_settings(const Config& config) {
  const ConfigValue& robots = config.value("robots");
  const auto refuse = [&](const char* key) {
    throw ConfigError(config.value(key).where,
                      fmt::format("found {} for {} robots ({}), expected it with one only",
                                  Config::flag_name(key), robots.text, robots.where.str()));
  };
  if (config.text("hal") != "sim") refuse("hal");
  for (const char* key : {"mix", "drive", "record"}) {
    if (config.is_set(key)) refuse(key);
  }
}

/// The scenario of `config` with as many robots as it asks for.
files::Scenario scenario_for_all(const Config& config) {
  files::Scenario scenario = named_scenario(config);
  const ConfigValue& value = config.value("robots");
  const std::size_t count = count_in(value);
  files::set_robot_count(scenario, count == kAll ? files::robots_meant(scenario) : count,
                         value.where);
  apply_error_settings(config, scenario);
  return scenario;
}

}  // namespace

SharedSim::SharedSim(files::Scenario scenario, const robot::SimulationSettings& settings,
                     double factor, Turns* turns, LogSink& log)
    : step_(from_seconds(settings.step)), turns_(turns) {
  for (const files::RobotPlacement& robot : scenario.robots) {
    robots_.push_back({scenario.models.at(robot.model).name, robot.program, robot.arguments});
  }
  world_ = std::make_shared<SimWorld>(std::move(scenario), settings, log);
  if (turns != nullptr) return;
  wall_ = std::make_shared<RealTimeClock>(step_, factor, [world = world_] { world->step(); });
  wall_->pause();  // until all robots are there
}

StateHash SharedSim::hash() {
  StateHash hash;
  hash.add(world_->locked([](auto& simulation) { return simulation.state_hash(); }));
  return hash;
}

std::uint64_t SharedSim::overruns() const { return wall_ ? wall_->overruns() : 0; }

std::shared_ptr<Clock> SharedSim::clock_of(std::size_t index) {
  if (wall_) return wall_;
  return std::make_shared<RoundClock>(*turns_, index);
}

std::size_t programs_wanted(const Config& config) {
  const std::size_t count = count_in(config.value("robots"));
  if (count == 1) return 1;
  check_alone_settings(config);
  return count != kAll ? count : files::robots_meant(named_scenario(config));
}

std::shared_ptr<SharedWorld> open_shared_world(const Config& config, LogSink& log, Turns* turns) {
  check_alone_settings(config);
  files::Scenario scenario = scenario_for_all(config);
  report_scenario(scenario, log);
  try {
    auto shared = std::make_shared<SharedSim>(std::move(scenario), simulation_settings(config),
                                              config.number("factor"), turns, log);
    begin_report(config, *shared->world());
    return shared;
  } catch (const std::invalid_argument& error) {
    throw ConfigError(config.value("world").where, error.what());
  }
}

}  // namespace eyebridge::hal
