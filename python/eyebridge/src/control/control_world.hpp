#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "eyebridge/hal/backend.hpp"
#include "eyebridge/hal/config.hpp"
#include "eyebridge/hal/environment.hpp"
#include "eyebridge/hal/shared_world.hpp"
#include "log/stderr_log.hpp"
#include "windows/map_board.hpp"

namespace eyebridge::robios {
class Windows;
}

namespace eyebridge::python {

/// The world that a control file drives: every robot of the scenario, stepped by the file's
/// routines, which take turns; windows on it, where the configuration wants some.
///
/// Time is virtual and passes in step() only. Where the run is to be watched (no `fast`), step()
/// takes as long as the step would on a clock. One thread but for what says otherwise.
class ControlWorld {
 public:
  /// Configured as a robot program `file` would be: flags of `eyebridge run`, variables,
  /// eyebridge.toml. All robots that the scenario places, unless `robots` is set. Throws
  /// ConfigError.
  explicit ControlWorld(const std::filesystem::path& file);
  ~ControlWorld();
  ControlWorld(const ControlWorld&) = delete;
  ControlWorld& operator=(const ControlWorld&) = delete;

  [[nodiscard]] const hal::Config& config() const { return config_; }
  /// One step of the simulation; waits while a person lets time stand still. Not while a robot is
  /// used.
  void step() { world_->step(); }
  [[nodiscard]] double step_length() const { return to_seconds(world_->step_length()); }
  [[nodiscard]] std::size_t robot_count() const { return robots_.size(); }
  /// `index` from 0. Its devices: any thread.
  [[nodiscard]] hal::Backend& robot(std::size_t index) { return *robots_.at(index); }
  /// As it came, but for the errors that refresh() found.
  [[nodiscard]] const robot::RobotModel& model(std::size_t index) const {
    return models_.at(index);
  }
  /// Looks which errors robot `index` has now: a person may have changed them. How often they were
  /// found changed.
  int refresh(std::size_t index);
  /// Where robot `index` really is. Any thread.
  [[nodiscard]] Pose truth(std::size_t index);
  /// What windows reach into. Any thread.
  [[nodiscard]] hal::Environment& environment() { return world_->environment(); }
  /// The world before its first step.
  [[nodiscard]] const world::Scene& scene() const { return first_look_.scene; }

  /// A number for the run's report, if one is kept (`report`): hal::SharedWorld::note().
  void note(const std::string& name, double value) { world_->note(name, value); }

  /// Opens windows where the configuration asks for them, or leaves it to us and there is a
  /// display. False where there are none. Throws ConfigError where `gui` is
  /// on and they cannot be.
  bool open_windows();
  /// Where windows take the two maps from that they show beside the world.
  [[nodiscard]] robios::MapBoard& belief_board() { return belief_board_; }
  [[nodiscard]] robios::MapBoard& map_board() { return map_board_; }
  [[nodiscard]] bool has_windows() const { return windows_ != nullptr; }
  /// A person has closed the last window. Any thread.
  [[nodiscard]] bool is_closed() const { return is_closed_; }
  /// Lets time go on that a person has paused. Any thread.
  void resume() { world_->environment().time().resume(); }
  /// The control file has ended: motors stop, the run's report is written. Once.
  void end();
  /// After end(): windows say `how` and stay until a person closes them.
  void finish(const std::string& how);
  /// The process ends at once, whatever its threads do: what is being written is completed. Any
  /// thread.
  void give_up();

 private:
  /// Robots are used by one routine at a time, and none of them has a clock of its own.
  class FreeTurns final : public hal::Turns {
   public:
    [[nodiscard]] const Time& limit_of(std::size_t /*robot*/) const override { return limit_; }
    void wait(std::size_t /*robot*/, Time /*time*/) override {}

   private:
    const Time limit_{std::numeric_limits<Time::rep>::max()};
  };

  const hal::Config config_;
  robios::StderrLog log_;
  FreeTurns turns_;
  const std::string program_;
  std::shared_ptr<hal::SharedWorld> world_;
  std::vector<std::unique_ptr<hal::Backend>> robots_;
  hal::WorldLook first_look_;
  std::vector<robot::RobotModel> models_;
  std::vector<int> changes_;  ///< Of their errors.
  robios::MapBoard belief_board_;
  robios::MapBoard map_board_;
  robios::Windows* windows_ = nullptr;
  std::atomic<bool> is_closed_ = false;
};

}  // namespace eyebridge::python
