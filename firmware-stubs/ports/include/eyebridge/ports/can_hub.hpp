#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/ports/port.hpp"

namespace eyebridge::ports {

/// Whether a CAN interface's name is the path of a bus on a Unix socket: it has a '/'.
inline bool is_can_path(std::string_view interface) {
  return interface.find('/') != std::string_view::npos;
}

/// A CAN bus for kernels without CAN: a Unix socket (SOCK_SEQPACKET) at `path`, which hands what a
/// node sends to all others, in SocketCAN's frames. No bit rate, no arbitration; who reads too
/// slowly misses frames. The socket goes away with the hub. Null when somebody serves `path`
/// already: then there is a bus to join. Throws ConfigError at `where`.
std::unique_ptr<Port> open_can_hub(const std::string& path, const SourceLocation& where);

}  // namespace eyebridge::ports
