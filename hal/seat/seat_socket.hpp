#pragma once

#include <cstdint>
#include <span>

#include "eyebridge/base/result.hpp"
#include "seat/message.hpp"

namespace eyebridge::hal {

/// Longer than any message that makes sense: a hundred thousand bodies in view are ten megabytes.
inline constexpr std::uint32_t kLongestMessage = 64U << 20U;

/// Sends one message, behind its length. Disconnected when the other end is gone.
Result<void> send_message(int socket, std::span<const std::uint8_t> message);

/// Waits for the next one. Disconnected when the other end is gone, Corrupt for a length that no
/// message has.
Result<Message> receive_message(int socket);

}  // namespace eyebridge::hal
