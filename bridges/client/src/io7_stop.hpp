#pragma once

#include <array>
#include <cstdint>

#include "eyebridge/bridges/guard/stop_orders.hpp"
#include "eyebridge/bridges/io7/probe.hpp"

namespace eyebridge::bridges {

/// Completes the longest binary request, whose arguments a board may still be waiting for. All 0:
/// as an argument that is "stop", as a letter it is none.
inline constexpr std::array<std::uint8_t, 6> kIo7Completion{};

/// What stops all motors of the board that `report` is of; its version is the answer.
StopOrders stop_orders(const io7::ProbeReport& report);

}  // namespace eyebridge::bridges
