#include "shared/shared_sim.hpp"

#include <charconv>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <strings.h>

#include "clock/round_clock.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/files/readers.hpp"
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

SharedSim::SharedSim(files::Scenario scenario, const Config& config, LogSink& log)
    : config_(config),
      step_(from_seconds(simulation_settings(config).step)),
      models_(scenario.models) {
  for (const files::RobotPlacement& robot : scenario.robots) {
    robots_.push_back({models_.at(robot.model).name, robot.program, robot.arguments});
  }
  for (const files::Newcomer& late : scenario.newcomers) {
    newcomers_.push_back({models_.at(late.robot.model), late.robot.pose, late.robot.program,
                          late.robot.arguments, from_seconds(late.time), late.where});
  }
  world_ = std::make_shared<SimWorld>(std::move(scenario), simulation_settings(config), log);
}

SharedSim::SharedSim(files::Scenario scenario, const Config& config, Turns* turns, LogSink& log)
    : SharedSim(std::move(scenario), config, log) {
  if (turns != nullptr) {
    begin_virtual(turns);
  } else {
    begin_real(RealTimeClock::Start::Later, log);
  }
}

std::shared_ptr<SharedSim> SharedSim::for_one(files::Scenario scenario, const Config& config,
                                              JoiningTurns* joining, LogSink& log) {
  std::shared_ptr<SharedSim> shared(new SharedSim(std::move(scenario), config, log));
  if (!config.boolean("fast")) {
    shared->begin_real(RealTimeClock::Start::AtOnce, log);
    return shared;
  }
  shared->begin_virtual(joining);
  auto make_step = [world = shared->world_, gate = shared->gate_] {
    gate->pass();
    world->step();
  };
  const Time step = shared->step_;
  if (joining == nullptr) {
    shared->first_ = std::make_shared<LockstepClock>(step, std::move(make_step));
    return shared;
  }
  shared->first_ = std::make_shared<LockstepClock>(
      step, [make_step = std::move(make_step), joining, step, end = Time(0)]() mutable {
        end += step;
        if (joining->has_any()) joining->before_step(end);
        make_step();
        if (joining->has_any()) joining->after_step();
      });
  return shared;
}

void SharedSim::begin_virtual(Turns* turns) {
  turns_ = turns;
  gate_ = std::make_shared<TimeGate>(step_);
  view_ = std::make_shared<SimEnvironment>(*world_, gate_);
}

void SharedSim::begin_real(RealTimeClock::Start start, LogSink& log) {
  wall_ = std::make_shared<RealTimeClock>(
      step_, config_.number("factor"), [world = world_] { world->step(); }, start);
  log.write(Severity::Info, "the world's thread has " + wall_->priority().str());
  view_ = std::make_shared<SimEnvironment>(*world_, wall_);
}

void SharedSim::step() {
  if (first_) {
    first_->wait_until(now() + step_);
    return;
  }
  gate_->pass();
  world_->step();
}

StateHash SharedSim::hash() {
  StateHash hash;
  hash.add(world_->locked([](auto& simulation) { return simulation.state_hash(); }));
  hash.add(world_->trace_value());
  hash.add(air_->trace_value());
  return hash;
}

std::uint64_t SharedSim::overruns() const { return wall_ ? wall_->overruns() : 0; }

std::shared_ptr<Clock> SharedSim::clock_of(std::size_t index) {
  if (wall_) return wall_;
  if (first_ && index == 0) return first_;
  return std::make_shared<RoundClock>(*turns_, index, now());
}

robot::RobotModel SharedSim::model(const std::string& name) const {
  for (const robot::RobotModel& model : models_) {
    if (strcasecmp(model.name.c_str(), name.c_str()) == 0) return model;
  }
  std::vector<Warning> known;  // nobody waits for them
  robot::RobotModel model = std::filesystem::path(name).extension() == ".robi"
                                ? files::read_robi(files::read_text_file(name), name, known)
                                : files::named_robot(name, {"robot"});
  apply_error_settings(config_, model);
  return model;
}

Result<std::size_t> SharedSim::enter(const Newcomer& newcomer) {
  return world_->add_robot(newcomer.model, newcomer.pose).map([](robot::RobotIndex index) {
    return std::size_t{index};
  });
}

std::size_t programs_wanted(const Config& config) {
  const std::size_t count = count_in(config.value("robots"));
  if (count == 1) return 1;
  check_alone_settings(config);
  if (count != kAll) return count;
  const files::Scenario scenario = named_scenario(config);
  return files::robots_meant(scenario) + scenario.newcomers.size();
}

void check_can_join(const Config& config) {
  for (const char* key : {"mix", "drive", "record"}) {
    if (!config.is_set(key)) continue;
    throw ConfigError(config.value(key).where,
                      fmt::format("found {}, which only a robot that is alone can have; no robot "
                                  "can be added to this run: start it without",
                                  Config::flag_name(key)));
  }
}

std::shared_ptr<SharedWorld> open_shared_world(const Config& config, LogSink& log, Turns* turns) {
  check_alone_settings(config);
  files::Scenario scenario = scenario_for_all(config);
  report_scenario(scenario, log);
  try {
    auto shared = std::make_shared<SharedSim>(std::move(scenario), config, turns, log);
    begin_report(config, *shared->world());
    return shared;
  } catch (const std::invalid_argument& error) {
    throw ConfigError(config.value("world").where, error.what());
  }
}

}  // namespace eyebridge::hal
