#pragma once

#include <cstddef>
#include <span>

#include <sys/types.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge {

/// As send() on a socket of this computer, and the receiver gets a copy of `descriptor`, lent;
/// negative: none. -1 and errno when it fails; a signal does not interrupt it.
ssize_t send_with_descriptor(int socket, std::span<const std::byte> bytes, int descriptor) noexcept;

/// As recv(); `descriptor` becomes the one that came along, or none. -1 and errno when it fails; a
/// signal does not interrupt it.
ssize_t receive_with_descriptor(int socket, std::span<std::byte> room,
                                UniqueFd& descriptor) noexcept;

}  // namespace eyebridge
