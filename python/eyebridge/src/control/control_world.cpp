#include "control_world.hpp"

#include <string>
#include <utility>

#include "eyebridge/hal/registry.hpp"
#include "windows/open_windows.hpp"

namespace eyebridge::python {
namespace {

hal::Config configuration(const std::filesystem::path& file) {
  hal::Config config = hal::Config::from_process(file);
  if (!config.value("robots").is_default()) return config;
  return config.with("robots", {"all", {"default"}});
}

}  // namespace

ControlWorld::ControlWorld(const std::filesystem::path& file)
    : config_(configuration(file)),
      log_(robios::lowest_severity(config_)),
      program_(file.filename().string()),
      world_(hal::open_shared_world(config_, log_, &turns_)) {
  for (std::size_t i = 0; i < world_->robots().size(); ++i) {
    const hal::WorldSlot slot{world_, i};
    robots_.push_back(hal::open_backend({config_, log_, &slot}));
  }
  hal::Environment& environment = world_->environment();
  environment.look(first_look_);
  for (const hal::RobotLook& robot : first_look_.robots) models_.push_back(*robot.model);
  changes_.resize(models_.size(), 0);
  // Cannot fail: the setting has the same range.
  if (!config_.boolean("fast")) (void)environment.time().set_factor(config_.number("factor"));
}

ControlWorld::~ControlWorld() = default;

Pose ControlWorld::truth(std::size_t index) {
  return world_->environment().control().robot_pose(static_cast<int>(index) + 1).value();
}

int ControlWorld::refresh(std::size_t index) {
  // Of a robot that was removed the last ones are known.
  auto present = world_->environment().present_model(index);
  if (present && *present != models_.at(index)) {
    models_[index] = std::move(*present);
    ++changes_[index];
  }
  return changes_.at(index);
}

bool ControlWorld::open_windows() {
  const auto quit = [this] {
    is_closed_ = true;
    resume();
  };
  windows_ = robios::open_windows(config_, log_, {quit, program_});
  hal::Environment& environment = world_->environment();
  if (windows_ == nullptr) {
    robios::tell_of_ignored_pause(environment, log_);
    return false;
  }
  robios::show_world(*windows_, environment);
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
