#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include <poll.h>

#include "eyebridge/bridges/monotonic_clock.hpp"
#include "eyebridge/pins/board_world.hpp"
#include "eyebridge/ports/port.hpp"
#include "rigs.hpp"
#include "run_program.hpp"

namespace eyebridge::hal::testing {

/// What is set in the firmware of a rig's board.
struct RigFirmware {
  bool vw_letters = true;
  int node = 0;  ///< On a CAN bus; 0: none.
  bool can_fd = false;
  int silence_ms = 300;  ///< On a serial line, that stop the motors.
  bool rover = false;    ///< Another robot: no board.
};

/// The robot of the rigs, driven by our firmware on a simulated board, in the same world.
class RigBoard {
 public:
  RigBoard(const Pose& start, const RigFirmware& firmware);
  ~RigBoard();
  RigBoard(const RigBoard&) = delete;
  RigBoard& operator=(const RigBoard&) = delete;

  /// The board, for the port that is to carry its line.
  [[nodiscard]] eb_board& board() { return *board_; }
  /// The same of a rover.
  [[nodiscard]] rv_rover& rover() { return *rover_; }
  void connect(std::unique_ptr<ports::Port> port) { port_ = std::move(port); }
  [[nodiscard]] const ports::Port& port() const { return *port_; }
  /// The line is gone, which the board notices or not. Any thread.
  void unplug(bool noticed = false);

  /// World, board and line live up to `now`; when they are due again. Only without start().
  Time live(Time now);
  /// They live in the computer's time from now on, on a thread of their own.
  void start();

  /// Any thread.
  [[nodiscard]] Truth truth();
  /// A file with the robot's HDT.
  [[nodiscard]] std::string hdt() const { return hdt_; }
  /// A folder that goes away with the board.
  [[nodiscard]] const std::string& folder() const { return folder_.path(); }

 private:
  void run(const std::stop_token& stop);
  [[nodiscard]] pollfd what_to_wait_for();

  eyebridge::testing::ScratchFolder folder_;
  std::string hdt_;
  bridges::MonotonicClock time_;
  std::mutex mutex_;  // of all below
  pins::BoardWorld world_;
  eb_board* board_ = nullptr;
  rv_rover* rover_ = nullptr;
  std::unique_ptr<ports::Port> port_;  // none after unplug()
  std::jthread thread_;
};

}  // namespace eyebridge::hal::testing
