#pragma once

#include <functional>
#include <memory>
#include <string>

#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/bridges/can_bus.hpp"

namespace eyebridge::bridges {

/// How a SocketCAN interface is opened.
struct SocketCanSettings {
  std::string interface;         ///< "can0", "vcan0"; at most 15 characters. With a '/' in it, as
                                 ///< "./eyebot.bus": the name of a Unix socket (SOCK_SEQPACKET)
                                 ///< whose server passes frames on, for kernels without CAN.
  bool fd = false;               ///< Also CAN FD frames; the interface's MTU must be 72.
  int receive_buffer = 1 << 20;  ///< Bytes asked of the kernel; the default of Linux holds some
                                 ///< 300 frames only.
};

/// A socket that carries whole frames as SocketCAN's CAN_RAW does, or a SOCK_SEQPACKET pair.
struct CanSocket {
  UniqueFd socket;
  bool fd = false;  ///< Takes CAN FD frames.
};

/// Opens a lost bus again, waiting for it until the deadline; fails with Disconnected.
using CanReopen = std::function<Result<CanSocket>(Time deadline)>;

/// Opens an interface. Fails with Unsupported on a kernel without CAN or when FD is wanted of a
/// classic interface, Disconnected when there is no such interface or it is down; the text says
/// which, and what to do. Lost (link down, adapter unplugged), it is opened again by name when it
/// comes back, with the same filters and empty queues. `clock` must outlive the bus.
Result<std::unique_ptr<CanBus>> open_socket_can(const SocketCanSettings& settings, Clock& clock);

/// A bus over a socket that is open already. Without `reopen` a loss is final.
std::unique_ptr<CanBus> make_socket_can(CanSocket socket, std::string name, Clock& clock,
                                        CanReopen reopen = {});

}  // namespace eyebridge::bridges
