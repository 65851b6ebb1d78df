#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "opcodes.h"

namespace eyebridge::bridges::can {

/// One CAN or CAN FD data frame with an 11-bit identifier.
struct Frame {
  std::uint16_t id = 0;     ///< 0 … 0x7FF: function << 4 | node.
  std::uint8_t length = 0;  ///< Bytes of `data` in use: 0 … 8, or with `fd` up to 64.
  bool fd = false;          ///< Sent as a CAN FD frame.
  std::array<std::uint8_t, 64> data{};

  [[nodiscard]] std::span<const std::uint8_t> bytes() const { return {data.data(), length}; }

  friend bool operator==(const Frame&, const Frame&) = default;
};

/// What a frame is about: one of EYECAN_C_…, EYECAN_S_…, EYECAN_HEARTBEAT.
constexpr int function_of(std::uint16_t id) { return id >> EYECAN_NODE_BITS; }
/// Which robot a frame is to or from; 0 for all, 15 for the host.
constexpr int node_of(std::uint16_t id) { return id & EYECAN_NODE_MASK; }

}  // namespace eyebridge::bridges::can
