#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "eyebridge/bridges/can_frame.hpp"

namespace eyebridge::bridges {

/// A frame as it is written to a CAN socket, and read from one.
struct CanSocketBytes {
  std::array<std::uint8_t, 72> bytes{};
  std::size_t size = 0;

  [[nodiscard]] std::span<const std::uint8_t> view() const { return {bytes.data(), size}; }
};

CanSocketBytes socket_bytes(const CanFrame& frame);

}  // namespace eyebridge::bridges
