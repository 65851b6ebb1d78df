#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "eyebridge/hal/environment.hpp"
#include "sim/sim_world.hpp"
#include "sim/sim_world_control.hpp"

namespace eyebridge::hal {

/// The environment of a simulated world.
class SimEnvironment final : public Environment {
 public:
  /// `world` is lent.
  SimEnvironment(SimWorld& world, std::shared_ptr<TimeControl> time)
      : world_(world), time_(std::move(time)), control_(world, 0) {}

  void look(WorldLook& look) override;
  [[nodiscard]] TimeControl& time() override { return *time_; }
  [[nodiscard]] WorldControl& control() override { return control_; }
  Result<void> drive(std::size_t index, const Twist& twist) override;
  Result<void> set_errors(std::size_t index, const robot::RobotModel& like) override;
  Result<robot::RobotModel> present_model(std::size_t index) override;
  [[nodiscard]] bool starts_paused() const override { return world_.starts_paused(); }
  [[nodiscard]] std::string directory() const override { return world_.directory(); }

 private:
  /// What `act` says of the simulation and the robot; OutOfRange where that is not there.
  template <class Act>
  auto with_robot(std::size_t index, Act act);

  SimWorld& world_;
  const std::shared_ptr<TimeControl> time_;
  SimWorldControl control_;
  std::mutex mutex_;
  /// Copies: the simulation's own move when a robot is added.
  std::vector<std::shared_ptr<const robot::RobotModel>> models_;
};

}  // namespace eyebridge::hal
