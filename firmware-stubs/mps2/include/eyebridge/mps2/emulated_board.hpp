#pragma once

#include <array>
#include <string>
#include <vector>

#include <poll.h>

#include "eyebridge/base/result.hpp"
#include "eyebridge/mps2/emulator.hpp"
#include "eyebridge/mps2/plant.hpp"
#include "eyebridge/ports/port.hpp"
#include "eyebridge/ports/trace.hpp"

namespace eyebridge::mps2 {

/// A board on an emulated microcontroller: the emulator, its firmware, and the robot that it drives
/// in a simulated world. Its host's line is a ByteLine, as that of every other board. Never waits,
/// but for its start; one thread.
class EmulatedBoard {
 public:
  /// Starts the emulator and waits until its firmware drives the robot. `world` outlives it; `now`
  /// is real time. Throws ConfigError as Emulator does, and when the firmware does not drive the
  /// robot within ten seconds.
  EmulatedBoard(const EmulatorSettings& settings, pins::BoardWorld& world, robot::RobotIndex robot,
                const eb_config& config, ports::Now now);

  /// The host's line, for any port; lives as long as the board.
  ports::ByteLine line();

  /// Moves what there is to move: between the firmware and the plant, and on the host's line. Fails
  /// with Disconnected when the emulator has ended, and with Timeout when the firmware was silent
  /// for ten seconds; both are final.
  Result<void> pump();
  /// What to poll() for, so that the next pump() finds something.
  [[nodiscard]] std::array<pollfd, 2> descriptors() const;

  [[nodiscard]] const Emulator& emulator() const { return emulator_; }

 private:
  void wait_for_firmware(const std::string& elf);
  bool serve_plant();
  bool serve_host();
  void take_from_host(std::span<const std::uint8_t> bytes);
  Result<void> ended();

  ports::Now now_;
  std::string command_;
  Emulator emulator_;
  Plant plant_;
  std::vector<std::uint8_t> to_plant_line_, to_board_, to_host_;
  std::uint64_t seen_periods_ = 0;
  Time heard_;
};

}  // namespace eyebridge::mps2
