#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/bridges/can_frame.hpp"
#include "eyebridge/bridges/dbc/checksum.hpp"
#include "eyebridge/bridges/dbc/database.hpp"

namespace eyebridge::bridges {

// How a robot is driven and heard by the messages of its own DBC file. Indices of signals are those
// in their message; every signal fits into it.

/// Counts the frames of a command: 0 … `last`, then 0 again.
struct DbcCounter {
  std::size_t signal = 0;
  std::uint64_t last = 0;
};

/// A byte that depends on all others of the frame.
struct DbcChecksum {
  enum class Kind { Xor, SaeJ1850, AutosarProfile1 };
  std::size_t signal = 0;  ///< 8 bits, a byte of their own.
  Kind kind = Kind::Xor;
  // Of AutosarProfile1:
  std::uint16_t data_id = 0;
  dbc::DataIdMode mode = dbc::DataIdMode::Both;
};

/// A message that is sent at its period.
struct DbcCommand {
  dbc::Message message;  ///< 1 … 64 bytes.
  Time period{0};        ///< > 0.
  /// What is sent while all wheels stand, without counter and checksum; as long as the message.
  std::vector<std::uint8_t> resting;
  std::optional<DbcCounter> counter;
  std::optional<DbcChecksum> checksum;
};

/// The speed of a wheel in a command.
struct DbcSetPoint {
  std::size_t command = 0;
  std::size_t signal = 0;
};

/// A number that the robot sends.
struct DbcReading {
  std::size_t status = 0;
  std::size_t signal = 0;
  std::optional<std::uint64_t> invalid;  ///< Bits that mean that there is no value.
  friend bool operator==(const DbcReading&, const DbcReading&) = default;
};

/// Everything that a DbcClient must know of its robot.
struct DbcPlan {
  std::string robot;  ///< As messages name it.
  std::vector<DbcCommand> commands;
  std::vector<DbcSetPoint> wheels;
  std::vector<dbc::Message> statuses;
  std::vector<DbcReading> readings;
  std::size_t heartbeat = 0;  ///< The status that proves that the robot lives.
  Time heartbeat_limit{0};    ///< After so long without it the robot counts as lost.
  /// A reading whose bits are `stopped_bits` while the robot stands.
  std::optional<std::size_t> stopped;
  std::uint64_t stopped_bits = 0;
  /// Readings that do not change while it stands, such as encoders.
  std::vector<std::size_t> still;
  bool has_watchdog = false;  ///< It stands by itself when no commands come.
};

/// The frame of `command` with these bytes, and with counter and checksum set.
CanFrame dbc_frame(const DbcCommand& command, const std::vector<std::uint8_t>& bytes,
                   std::uint64_t counter);
/// The counter of the frame after the one with `counter`.
std::uint64_t next_counter(const DbcCommand& command, std::uint64_t counter);
/// Whether `frame` is one of `message`'s.
bool is_of(const dbc::Message& message, const CanFrame& frame);

}  // namespace eyebridge::bridges
