#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "../hal/rigs.hpp"
#include "eyebridge/mps2/emulated_board.hpp"
#include "run_program.hpp"

namespace eyebridge::mps2 {

/// A board on an emulated Cortex-M3 that drives the first robot of a world, reached over a
/// pseudo-terminal. It lives on a thread of its own.
class CortexRig {
 public:
  explicit CortexRig(const eb_config& config,
                     const files::Scenario& scenario = hal::rig_scenario(2.5));
  ~CortexRig();
  CortexRig(const CortexRig&) = delete;
  CortexRig& operator=(const CortexRig&) = delete;

  /// What a program opens: the line, the robot's HDT file, and `profile`, io7 or io7vw.
  [[nodiscard]] std::string url(const std::string& profile) const;
  /// That backend, opened as a program does.
  [[nodiscard]] hal::Rig open(const std::string& profile) const;
  /// The name of the pseudo-terminal.
  [[nodiscard]] std::string device() const { return folder_.path() + "/eyebot.tty"; }
  [[nodiscard]] pid_t pid() const { return board_->emulator().pid(); }

  /// Waits until the robot's world is as `seen` wants it; false when it is not within a minute.
  bool wait_for(const std::function<bool(robot::Simulation&)>& seen);
  /// Shows the world as it is now.
  void look(const std::function<void(robot::Simulation&)>& show);
  /// Where the robot really is.
  Pose pose();
  /// That, and where its camera looks; the robot must have one.
  hal::Truth truth();
  /// What the board's wires carry now, by the plant.
  eb_pins pins();
  /// Waits until the board has ended, and why it did; "" when it does not within a minute.
  std::string wait_for_end();

 private:
  void live(const std::stop_token& stop);

  eyebridge::testing::ScratchFolder folder_;
  std::string hdt_;
  pins::BoardWorld world_;
  std::unique_ptr<EmulatedBoard> board_;
  std::unique_ptr<ports::Port> port_;
  std::mutex mutex_;  // of all of the above while the thread runs
  std::condition_variable turned_;
  std::string end_;
  std::jthread thread_;
};

/// The default dialect, with the v-omega letters or without. The watchdog waits for ten seconds: a
/// busy machine must not look like a program that fell silent.
eb_config dialect(bool vw);

}  // namespace eyebridge::mps2
