#pragma once

#include <memory>
#include <vector>

#include "clock/lockstep_clock.hpp"
#include "clock/real_time_clock.hpp"
#include "clock/time_gate.hpp"
#include "eyebridge/hal/shared_world.hpp"
#include "radio/radio_medium.hpp"
#include "sim/sim_environment.hpp"
#include "sim/sim_world.hpp"

namespace eyebridge::hal {

/// A simulated world with robots that run programs of their own, and what they share besides: the
/// air for their radios, and real time.
class SharedSim final : public SharedWorld {
 public:
  /// Virtual time by `turns`, lent; real time when that is null. Throws as SimWorld.
  SharedSim(files::Scenario scenario, const Config& config, Turns* turns, LogSink& log);
  /// The world of one robot that runs a program, which others may join: its threads step the world
  /// in virtual time (`fast`), and call `joining`, lent, for the others; null where none can join.
  /// Time begins at once. Throws as SimWorld.
  static std::shared_ptr<SharedSim> for_one(files::Scenario scenario, const Config& config,
                                            JoiningTurns* joining, LogSink& log);

  [[nodiscard]] const std::vector<SharedRobot>& robots() const override { return robots_; }
  [[nodiscard]] const std::vector<Newcomer>& newcomers() const override { return newcomers_; }
  [[nodiscard]] robot::RobotModel model(const std::string& name) const override;
  Result<std::size_t> enter(const Newcomer& newcomer) override;
  Result<void> leave(std::size_t robot) override { return world_->remove_robot(robot); }
  [[nodiscard]] Result<void> can_leave(std::size_t robot) override {
    return world_->check_there(robot);
  }
  [[nodiscard]] Time now() override { return world_->now(); }
  void wait_until(Time time) override {
    if (wall_) wall_->wait_until(time);
  }
  [[nodiscard]] Time step_length() const override { return step_; }
  void begin_time() override {
    if (wall_) wall_->begin();
  }
  void step() override;
  [[nodiscard]] Environment& environment() override { return *view_; }
  void note(const std::string& name, double value) override { world_->note(name, value); }
  void end() noexcept override { world_->end_report(); }
  [[nodiscard]] std::string lost_results() override { return world_->lost_report(); }
  [[nodiscard]] StateHash hash() override;
  [[nodiscard]] std::uint64_t overruns() const override;

  [[nodiscard]] std::shared_ptr<SimWorld> world() { return world_; }
  [[nodiscard]] std::shared_ptr<Environment> view() { return view_; }
  [[nodiscard]] std::shared_ptr<RadioMedium> air() { return air_; }
  /// The time that robot `index` lives in, from now on.
  std::shared_ptr<Clock> clock_of(std::size_t index);

 private:
  /// Without time.
  SharedSim(files::Scenario scenario, const Config& config, LogSink& log);
  void begin_virtual(Turns* turns);
  void begin_real(RealTimeClock::Start start, LogSink& log);

  const Config config_;
  const Time step_;
  Turns* turns_ = nullptr;
  std::vector<SharedRobot> robots_;
  std::vector<Newcomer> newcomers_;
  const std::vector<robot::RobotModel> models_;  ///< The scenario's.
  std::shared_ptr<SimWorld> world_;
  std::shared_ptr<RadioMedium> air_ = std::make_shared<RadioMedium>();
  std::shared_ptr<TimeGate> gate_;        ///< Null in real time.
  std::shared_ptr<RealTimeClock> wall_;   ///< After the world that it steps; null in virtual time.
  std::shared_ptr<LockstepClock> first_;  ///< Of a robot that began alone, in virtual time.
  std::shared_ptr<Environment> view_;
};

}  // namespace eyebridge::hal
