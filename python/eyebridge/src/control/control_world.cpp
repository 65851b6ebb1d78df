#include "control_world.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/hal/registry.hpp"
#include "windows/load_windows.hpp"

namespace eyebridge::python {
namespace {

hal::Config configuration(const std::filesystem::path& file) {
  hal::Config config = hal::Config::from_process(file);
  if (!config.value("robots").is_default()) return config;
  return config.with("robots", {"all", {"default"}});
}

Severity least_severity(const std::string& name) {
  if (name == "debug") return Severity::Debug;
  if (name == "info") return Severity::Info;
  return name == "error" ? Severity::Error : Severity::Warning;
}

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

/// As robios/windows: only what is watched has windows unless somebody says so.
bool wants_windows(const hal::Config& config) {
  const std::string gui = config.text("gui");
  if (gui != "auto") return gui == "on";
  return !config.boolean("fast") && (is_set("DISPLAY") || is_set("WAYLAND_DISPLAY"));
}

}  // namespace

void ControlWorld::ErrorLog::write(Severity severity, std::string_view message) {
  if (severity >= least_) fmt::print(stderr, "eyebridge: {}\n", message);
}

ControlWorld::ControlWorld(const std::filesystem::path& file)
    : config_(configuration(file)),
      log_(least_severity(config_.text("log"))),
      program_(file.filename().string()),
      world_(hal::open_shared_world(config_, log_, &turns_)) {
  for (std::size_t i = 0; i < world_->robots().size(); ++i) {
    const hal::Seat seat{world_, i};
    robots_.push_back(hal::open_backend({config_, log_, &seat}));
  }
  hal::Environment& environment = world_->environment();
  environment.look(first_look_);
  for (const hal::RobotLook& robot : first_look_.robots) models_.push_back(robot.model);
  // Cannot fail: the setting has the same range.
  if (!config_.boolean("fast")) (void)environment.time().set_factor(config_.number("factor"));
}

ControlWorld::~ControlWorld() = default;

Pose ControlWorld::truth(std::size_t index) {
  return world_->environment().control().robot_pose(static_cast<int>(index) + 1).value();
}

std::uint64_t ControlWorld::collisions() {
  hal::WorldLook look;
  world_->environment().look(look);
  return look.collision_count;
}

bool ControlWorld::open_windows(const std::filesystem::path& folder) {
  if (!wants_windows(config_)) return false;
  std::string why;
  windows_ = robios::load_windows(folder,
                                  {[this] {
                                     is_closed_ = true;
                                     resume();
                                   },
                                   program_},
                                  why);
  if (windows_ == nullptr) {
    if (config_.text("gui") != "on") return false;
    throw ConfigError(config_.value("gui").where,
                      "no windows can be opened: " + why + ", or gui = off");
  }
  hal::Environment& environment = world_->environment();
  if (environment.starts_paused()) environment.time().pause();
  windows_->open_environment(environment, nullptr);
  windows_->open_map({"Belief", &belief_board_});
  windows_->open_map({"Map", &map_board_});
  return true;
}

void ControlWorld::end() {
  for (const auto& robot : robots_) robot->stop();
  world_->end();
}

void ControlWorld::finish(const std::string& how) {
  if (windows_ != nullptr) windows_->finish(how);
}

void ControlWorld::give_up() {
  world_->end();
  if (windows_ != nullptr) windows_->complete_files();
}

}  // namespace eyebridge::python
