#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eyebridge::bridges::dbc {

enum class ByteOrder {
  Motorola,  ///< `@0`, big-endian: `start` is the most significant bit.
  Intel,     ///< `@1`, little-endian: `start` is the least significant bit.
};

enum class NumberKind { Unsigned, Signed, Float32, Float64 };

/// A raw value with a name: `0 "Standby"`.
struct NamedValue {
  std::int64_t value = 0;
  std::string name;
};

/// Raw values of a multiplexer, both ends included.
struct SelectorRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};

/// One number in a message.
struct Signal {
  std::string name;
  int start = 0;   ///< 0 … 511. Bit n is bit n % 8 (0: least significant) of byte n / 8.
  int length = 1;  ///< Bits, 1 … 64.
  ByteOrder order = ByteOrder::Intel;
  NumberKind kind = NumberKind::Unsigned;
  double factor = 1;  ///< Value = raw * factor + offset, in `unit`.
  double offset = 0;
  double minimum = 0;  ///< Of the value; no limit where both are 0.
  double maximum = 0;
  std::string unit;
  std::vector<std::string> receivers;
  bool multiplexer = false;  ///< Its raw value selects other signals.
  /// Index in the message of the multiplexer that selects this one. None: always present.
  std::optional<std::size_t> selector;
  std::vector<SelectorRange> selected_by;
  std::vector<NamedValue> values;
  std::string comment;
  int line = 0;  ///< In the file.
};

/// One kind of frame.
struct Message {
  std::string name;
  std::uint32_t id = 0;
  bool extended = false;  ///< 29-bit identifier.
  bool fd = false;        ///< By VFrameFormat, or by its length.
  int length = 0;         ///< Bytes, 0 … 64.
  std::string sender;
  std::vector<Signal> signals;
  std::optional<int> period_ms;       ///< GenMsgCycleTime; none where the file says 0 or nothing.
  std::optional<int> start_delay_ms;  ///< GenMsgStartDelayTime.
  std::string comment;
  int line = 0;  ///< In the file.

  /// The signal `name`; null when there is none, or more than one.
  [[nodiscard]] const Signal* find(std::string_view name) const;
};

/// What a DBC file says.
struct Database {
  std::string version;
  std::vector<std::string> nodes;
  std::vector<Message> messages;

  /// The message `name`; null when there is none, or more than one.
  [[nodiscard]] const Message* find(std::string_view name) const;
};

}  // namespace eyebridge::bridges::dbc
