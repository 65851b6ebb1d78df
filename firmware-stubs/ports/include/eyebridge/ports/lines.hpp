#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/ports/port.hpp"

namespace eyebridge::ports {

/// A pseudo-terminal, in raw mode before anybody opens it, with a symbolic link `link` to it. When
/// the host closes it the board's link is lost, and the next host finds the same name. The link
/// goes away with the port. Throws ConfigError at `where` when `link` exists already (one that
/// points nowhere, or to a terminal that only its host has open, as a killed process leaves it, is
/// replaced) or cannot be made.
std::unique_ptr<Port> open_pty(ByteLine line, const std::string& link, const SourceLocation& where);

/// A TCP server for one host at a time; others are told so and sent away. `address` is a port, on
/// this machine only, or ADDRESS:PORT; port 0 takes a free one (address() tells which). Throws
/// ConfigError at `where`.
std::unique_ptr<Port> open_tcp(ByteLine line, const std::string& address,
                               const SourceLocation& where);

/// Where on a bus a node's 11-bit identifiers lie: each plus `offset`, with 29 bits when
/// `extended`.
struct CanPlace {
  std::uint32_t offset = 0;
  bool extended = false;

  /// `frame` as the board knows it; false when it is not there.
  bool take(eb_can_frame& frame) const;
  /// `frame` as the bus carries it.
  [[nodiscard]] eb_can_frame placed(eb_can_frame frame) const;
};

/// A node on a SocketCAN interface, or on the bus of a can_hub.hpp when `interface` is its path.
/// Throws ConfigError at `where`, telling a kernel without CAN (97), one without raw sockets (93)
/// and a missing interface (19) apart. An interface that goes away later is opened again when it
/// comes back. `node` is for address();
/// 0: a robot with messages of its own.
std::unique_ptr<Port> open_can(FrameLine line, const std::string& interface, bool fd, int node,
                               const SourceLocation& where, CanPlace place = {});

/// A node on a socket that carries frames as SocketCAN does; a loss is final.
std::unique_ptr<Port> make_can_port(FrameLine line, UniqueFd socket);

}  // namespace eyebridge::ports
