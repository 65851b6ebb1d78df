#pragma once

#include <cstddef>
#include <span>

#include <sys/types.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge {

/// Like send() on a Unix socket; also passes a copy of `descriptor`, which is lent (negative:
/// none). -1 and errno when it fails. Repeats after EINTR; no cancellation point.
ssize_t send_with_descriptor(int socket, std::span<const std::byte> bytes, int descriptor) noexcept;

/// Like recv(); sets `descriptor` to the one that was passed, or to none. -1 and errno when it
/// fails: EMFILE when this process has no room for the descriptor. Repeats after EINTR; no
/// cancellation point.
ssize_t receive_with_descriptor(int socket, std::span<std::byte> room,
                                UniqueFd& descriptor) noexcept;

}  // namespace eyebridge
