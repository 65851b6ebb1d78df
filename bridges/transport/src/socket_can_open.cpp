#include <algorithm>
#include <cerrno>
#include <cstring>

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include "can_path.hpp"
#include "eyebridge/bridges/socket_can.hpp"
#include "wait.hpp"

namespace eyebridge::bridges {
namespace {

tl::unexpected<Error> no_socket(const std::string& name, int error) {
  if (error == EAFNOSUPPORT || error == EPROTONOSUPPORT) {
    return fail(Errc::Unsupported, name + ": this kernel has no CAN (errno " +
                                       std::to_string(error) +
                                       "); expected one with the modules can and can-raw");
  }
  return fail(Errc::Disconnected, name + ": cannot open a CAN socket: " + errno_text(error));
}

template <class T>
bool set_option(int fd, int level, int option, const T& value) {
  return ::setsockopt(fd, level, option, &value, sizeof value) == 0;
}

/// Null when the interface `request` names can be used; else what is wrong.
Result<void> check_interface(int fd, ifreq& request, const SocketCanSettings& settings) {
  const std::string& name = settings.interface;
  if (::ioctl(fd, SIOCGIFFLAGS, &request) != 0) {
    return fail(Errc::Disconnected, name + ": no such CAN interface: " + errno_text(errno));
  }
  const bool is_up = (request.ifr_flags & IFF_UP) != 0;
  if (::ioctl(fd, SIOCGIFHWADDR, &request) != 0 || request.ifr_hwaddr.sa_family != ARPHRD_CAN) {
    return fail(Errc::Unsupported, name + ": is a network interface, but not for CAN");
  }
  if (!is_up) {
    return fail(Errc::Disconnected,
                name + ": the interface is down; expected it up, as after: ip link set " + name +
                    " up type can bitrate 500000 (for vcan without type and bit rate)");
  }
  if (::ioctl(fd, SIOCGIFMTU, &request) != 0) {
    return fail(Errc::Disconnected, name + ": " + errno_text(errno));
  }
  if (settings.fd && request.ifr_mtu < static_cast<int>(CANFD_MTU)) {
    return fail(Errc::Unsupported, name + ": is set up for classic CAN (MTU " +
                                       std::to_string(request.ifr_mtu) +
                                       "); expected CAN FD (MTU 72)");
  }
  return {};
}

bool set_options(int fd, const SocketCanSettings& settings) {
  const int on = 1;
  // FORCE goes beyond the system's limit but needs a privilege; without, the limit applies.
  if (!set_option(fd, SOL_SOCKET, SO_RCVBUFFORCE, settings.receive_buffer) &&
      !set_option(fd, SOL_SOCKET, SO_RCVBUF, settings.receive_buffer)) {
    return false;
  }
  // The smallest send buffer, fewer frames than the device queues: so poll() can tell when there is
  // room, which it cannot once the device answers ENOBUFS.
  return set_option(fd, SOL_SOCKET, SO_SNDBUF, 0) && set_option(fd, SOL_SOCKET, SO_RXQ_OVFL, on) &&
         set_option(fd, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, can_err_mask_t{CAN_ERR_MASK}) &&
         (!settings.fd || set_option(fd, SOL_CAN_RAW, CAN_RAW_FD_FRAMES, on));
}

Result<CanSocket> open_socket(const SocketCanSettings& settings) {
  const std::string& name = settings.interface;
  if (is_can_path(name)) return connect_can_path(settings);
  ifreq request{};
  if (name.empty() || name.size() >= sizeof request.ifr_name) {
    return fail(Errc::OutOfRange,
                "'" + name + "': expected an interface name of 1 to 15 characters");
  }
  std::memcpy(request.ifr_name, name.data(), name.size());

  UniqueFd fd(::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW));
  if (!fd.valid()) return no_socket(name, errno);
  if (auto good = check_interface(fd.get(), request, settings); !good) {
    return tl::unexpected(std::move(good.error()));
  }
  sockaddr_can address{};
  address.can_family = AF_CAN;
  if (::ioctl(fd.get(), SIOCGIFINDEX, &request) != 0 || !set_options(fd.get(), settings)) {
    return fail(Errc::Disconnected, name + ": cannot be set up: " + errno_text(errno));
  }
  address.can_ifindex = request.ifr_ifindex;
  if (::bind(fd.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    return fail(Errc::Disconnected, name + ": cannot be bound: " + errno_text(errno));
  }
  return CanSocket{std::move(fd), settings.fd};
}

}  // namespace

Result<std::unique_ptr<CanBus>> open_socket_can(const SocketCanSettings& settings, Clock& clock) {
  Result<CanSocket> socket = open_socket(settings);
  if (!socket) return tl::unexpected(std::move(socket.error()));
  const auto reopen = [settings, &clock](Time deadline) {
    constexpr Time kPause = std::chrono::milliseconds(20);
    while (true) {
      Result<CanSocket> again = open_socket(settings);
      const Time now = clock.now();
      if (again || now >= deadline) return again;
      clock.wait_until(std::min(deadline, now + kPause));
    }
  };
  return make_socket_can(std::move(*socket), settings.interface, clock, reopen);
}

}  // namespace eyebridge::bridges
