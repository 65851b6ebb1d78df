#pragma once

#include <cstdint>

#include "eyebridge/bridges/can_frame.hpp"
#include "opcodes.h"

namespace eyebridge::bridges::can {

/// Whether a frame may be one of the protocol: 11-bit identifier, data, from the bus.
constexpr bool is_protocol_format(const CanFrame& frame) {
  return !frame.extended && !frame.remote && !frame.error && frame.id <= CanFrame::kMaxStandardId;
}

/// What an 11-bit identifier is about: one of EYECAN_C_…, EYECAN_S_…, EYECAN_HEARTBEAT.
constexpr int function_of(std::uint32_t id) { return static_cast<int>(id >> EYECAN_NODE_BITS); }
/// Which robot it is to or from; 0 for all, 15 for the host.
constexpr int node_of(std::uint32_t id) { return static_cast<int>(id & EYECAN_NODE_MASK); }

}  // namespace eyebridge::bridges::can
