#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "opcodes.h"

namespace eyebridge::bridges::can {

/// The most points of one LIDAR scan: 12 bits of chunk index, 3 points a chunk.
inline constexpr int kMaxLidarPoints = 12288;

/// One number in a frame. Little-endian ("Intel"); bit 0 is the lowest of byte 0.
struct Signal {
  std::string_view name;
  std::uint16_t start = 0;  ///< Lowest bit.
  std::uint8_t length = 0;  ///< Bits, 1 … 32.
  bool is_signed = false;   ///< Two's complement.
  double scale = 1.0;       ///< Physical value = raw × scale + offset.
  double offset = 0.0;
  std::string_view unit;
  std::int64_t first = 0;      ///< Lowest raw value that is accepted.
  std::int64_t last = 0;       ///< Highest raw value that is accepted.
  bool may_be_absent = false;  ///< EYECAN_ABSENT is accepted, too.
  int bank = -1;               ///< Only there when the first signal has this value; -1: always.

  /// True when a frame may carry `raw`.
  [[nodiscard]] constexpr bool accepts(std::int64_t raw) const {
    return (raw >= first && raw <= last) || (may_be_absent && raw == EYECAN_ABSENT);
  }
  [[nodiscard]] constexpr double physical(std::int64_t raw) const {
    return static_cast<double>(raw) * scale + offset;
  }
};

enum class Direction : std::uint8_t {
  HostToRobot,
  RobotToHost,
  Both,
};

/// One kind of frame: what is said about it here is said nowhere else. The codec, the DBC files and
/// the checks in the tests are all made from this.
struct MessageSpec {
  std::string_view name;
  std::uint8_t function = 0;  ///< Upper seven bits of the identifier.
  std::uint8_t first_node = EYECAN_NODE_FIRST;
  std::uint8_t last_node = EYECAN_NODE_LAST;
  Direction direction = Direction::RobotToHost;
  std::uint8_t length = 8;      ///< Bytes sent; shorter frames are refused, longer ones are read.
  std::uint16_t period_ms = 0;  ///< 0: only on an event.
  std::span<const Signal> signals;
  std::string_view comment;
  /// A rule over all raw values, in the order of the signals; null: none.
  bool (*consistent)(std::span<const std::int64_t> values) = nullptr;
  bool fd = false;           ///< A CAN FD frame.
  bool multiplexed = false;  ///< The first signal tells which bank of the others is there.

  /// The identifier to or from `node`.
  [[nodiscard]] constexpr std::uint16_t id(int node) const {
    return static_cast<std::uint16_t>(function << EYECAN_NODE_BITS | node);
  }
};

/// Every kind of message, in the order of identifiers; S_LidarChunkFD follows S_LidarChunk.
std::span<const MessageSpec> messages();

/// The row called `name`; null when there is none.
const MessageSpec* find_message(std::string_view name);
/// The row of the frames with this function and format; null when there is none.
const MessageSpec* find_message(int function, bool fd);

}  // namespace eyebridge::bridges::can
