#pragma once

#include <cstdint>
#include <span>
#include <string_view>

// What the protocol is. opcodes.h is written from this table, so nothing here may include it.
namespace eyebridge::bridges::can {

/// Identifiers: function << kNodeBits | node.
inline constexpr int kNodeBits = 4;
inline constexpr int kNodeMask = (1 << kNodeBits) - 1;
inline constexpr int kFunctionMask = 0x7FF & ~kNodeMask;
inline constexpr int kNodeAll = 0;
inline constexpr int kFirstNode = 1;
inline constexpr int kLastNode = 14;
inline constexpr int kNodeHost = 15;
inline constexpr int kProtocolVersion = 1;
/// Unsigned 16-bit values that mean "none", ranges in mm that mean "beyond reach".
inline constexpr std::int64_t kAbsent = 0xFFFF;
inline constexpr std::int64_t kOutOfRange = 9999;
/// The most points of one LIDAR scan: 12 bits of chunk index, 3 points a chunk.
inline constexpr int kMaxLidarPoints = 12288;
/// Zones of a range matrix: eight rows of eight, three a frame.
inline constexpr int kMostMatrices = 8;
inline constexpr int kZoneCount = 64;
inline constexpr int kLastZoneChunk = (kZoneCount - 1) / 3;

/// A number with a name.
struct Name {
  std::string_view name;
  std::int64_t number = 0;
  std::string_view meaning;  ///< A sentence.
};

/// Numbers that belong together. In opcodes.h each is EYECAN_<prefix><name>; in DBC files it is
/// `name`, where a signal refers to the group.
struct NameGroup {
  std::string_view prefix;
  std::string_view title;  ///< Whose numbers they are.
  std::span<const Name> names;
  int hex_digits = 0;      ///< As which they are written; 0: decimal.
  bool are_bits = false;   ///< A value is a sum of them.
  bool is_closed = false;  ///< Other values are refused.
};

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
  bool may_be_absent = false;  ///< kAbsent is accepted, too.
  int bank = -1;               ///< Only there when the first signal has this value; -1: always.
  const NameGroup* names = nullptr;  ///< Of its values; null: they have none.
  std::string_view comment;          ///< A sentence; empty: the name says all.

  /// True when a frame may carry `raw`.
  [[nodiscard]] constexpr bool accepts(std::int64_t raw) const {
    return (raw >= first && raw <= last) || (may_be_absent && raw == kAbsent);
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

/// One kind of frame: what is said about it here is said nowhere else. The codec, the DBC files,
/// opcodes.h and the tables of SPECIFICATION.md are all made from this.
struct MessageSpec {
  std::string_view name;
  std::string_view c_name;    ///< Its function in opcodes.h, behind EYECAN_.
  std::uint8_t function = 0;  ///< Upper seven bits of the identifier.
  std::uint8_t first_node = kFirstNode;
  std::uint8_t last_node = kLastNode;
  Direction direction = Direction::RobotToHost;
  std::uint8_t length = 8;      ///< Bytes sent; shorter frames are refused, longer ones are read.
  std::uint16_t period_ms = 0;  ///< 0: only on an event.
  std::span<const Signal> signals;
  std::string_view example;  ///< A frame, as in tests/data/protocol/can.hex.
  std::string_view comment;
  /// A rule over all raw values, in the order of the signals; null: none.
  bool (*consistent)(std::span<const std::int64_t> values) = nullptr;
  bool fd = false;           ///< A CAN FD frame.
  bool multiplexed = false;  ///< The first signal tells which bank of the others is there.

  /// The identifier to or from `node`.
  [[nodiscard]] constexpr std::uint16_t id(int node) const {
    return static_cast<std::uint16_t>(function << kNodeBits | node);
  }
};

/// Every kind of message, in the order of identifiers; S_LidarChunkFD follows S_LidarChunk.
std::span<const MessageSpec> messages();

/// Every group of names, in the order in which they are written.
std::span<const NameGroup* const> name_groups();

/// The row called `name`; null when there is none.
const MessageSpec* find_message(std::string_view name);
/// The row of the frames with this function and format; null when there is none.
const MessageSpec* find_message(int function, bool fd);

}  // namespace eyebridge::bridges::can
