#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "control_server.hpp"
#include "eyebridge/hal/config.hpp"
#include "eyebridge/hal/shared_world.hpp"
#include "launcher_calls.h"
#include "log/stderr_log.hpp"
#include "robot.hpp"
#include "windows/windows.hpp"

namespace eyebridge::robios {

/// Several robots in one world, each with its program, from their start to the last one's end.
class Fleet final : public Crew {
 public:
  /// `words` as programs_of() takes them; `calls` are set before a thread is there that asks them.
  /// Throws ConfigError.
  Fleet(hal::Config config, const std::vector<std::string>& words, eyebridge_robot_calls& calls);
  ~Fleet() override;
  Fleet(const Fleet&) = delete;
  Fleet& operator=(const Fleet&) = delete;

  /// Runs all programs to their end. Returns the first exit code that is not 0, by the robots'
  /// numbers.
  int run();
  /// Lets a robot enter the world of a run: its index. In virtual time it comes between two rounds,
  /// whichever is next; a scenario's own newcomers come at their times by themselves. OutOfRange
  /// where it would stand in something. Any thread but those of programs, in virtual time.
  Result<std::size_t> add(hal::Newcomer newcomer);
  Result<std::size_t> add(const Words& words) override;
  /// As add(): in virtual time between two rounds.
  Result<void> remove(std::size_t index) override;
  [[nodiscard]] hal::SharedWorld& world() { return *world_; }
  /// end(), for a signal that ends the process then: run() does not return. Any thread.
  void stop();
  /// Ends every robot's session: motors stop, results are written. Any thread.
  void end();

 private:
  struct Scheduler;
  struct InLockstep;
  struct InRealTime;

  /// `hang_limit`: s without a call.
  static std::unique_ptr<Scheduler> in_lockstep(double hang_limit);
  static std::unique_ptr<Scheduler> in_real_time(double hang_limit);
  /// When the time limit of all is over.
  static bool comes_too_late(Time time, const hal::Config& config);

  void add_robots(const std::vector<std::string>& words);
  /// Gives robot `index` its program and session; null for one without a program.
  Robot* add_robot(std::size_t index, RobotProgram program);
  /// What somebody at the control socket wants: a robot's index, who came or went.
  Result<std::size_t> answer(const Words& words);
  /// What a newcomer runs.
  [[nodiscard]] RobotProgram program_of(const hal::Newcomer& newcomer) const;
  /// Lets a robot enter now.
  Result<std::size_t> enter(const hal::Newcomer& newcomer, RobotProgram program);
  /// Ends robot `index` and takes it out of the world now: its index.
  Result<std::size_t> leave(std::size_t index);
  /// When the scenario's next newcomer comes; nothing when all have.
  [[nodiscard]] std::optional<Time> next_entry() const;
  /// Lets that one enter. False when none runs a program then: it was refused, or has none.
  bool let_next_in();
  /// Those with a program, for a look at them: one more may come meanwhile.
  [[nodiscard]] std::vector<Robot*> robots() const;
  /// Ten times a second, in a thread of ours.
  void look();
  /// Ends the run, and the process: the program of `broken` crashed, or hangs.
  [[noreturn]] void end_without(Robot& broken);
  [[nodiscard]] int exit_code() const;

  const hal::Config config_;
  StderrLog log_;
  std::unique_ptr<Scheduler> scheduler_;
  std::shared_ptr<hal::SharedWorld> world_;
  std::filesystem::path scenario_;               ///< For messages, and beside which programs lie.
  std::vector<RobotProgram> newcomer_programs_;  ///< Of the scenario's newcomers that do come.
  std::size_t entries_ = 0;                      ///< How many of them have been asked in.
  bool has_refused_ = false;                     ///< One of them.
  bool has_lost_results_ = false;                ///< Of the world.
  std::optional<ControlServer> control_;
  Windows* windows_ = nullptr;                  ///< Of the process; null for none.
  mutable std::mutex mutex_;                    ///< Who enters, and robots_.
  std::mutex leaving_;                          ///< One robot at a time is removed.
  std::vector<std::unique_ptr<Robot>> robots_;  ///< Those with a program.
  std::atomic<bool> is_stopped_ = false;
};

}  // namespace eyebridge::robios
