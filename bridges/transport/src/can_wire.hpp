#pragma once

#include <cstddef>
#include <optional>

#include <linux/can.h>

#include "eyebridge/bridges/can_frame.hpp"

namespace eyebridge::bridges {

/// `frame` as the kernel has it; returns its size there: CAN_MTU, or CANFD_MTU for CAN FD.
std::size_t to_wire(const CanFrame& frame, canfd_frame& out);

/// The frame in `size` bytes from the kernel; none when they cannot be one.
std::optional<CanFrame> from_wire(const canfd_frame& in, std::size_t size);

}  // namespace eyebridge::bridges
