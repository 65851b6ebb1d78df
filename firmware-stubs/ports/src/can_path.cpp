#include "can_path.hpp"

#include <cerrno>
#include <utility>

#include <sys/socket.h>

namespace eyebridge::ports {

std::optional<sockaddr_un> can_path_address(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) return std::nullopt;
  path.copy(address.sun_path, path.size());
  return address;
}

Opened connect_can_path(const std::string& path) {
  const auto address = can_path_address(path);
  if (!address) return {{}, ENAMETOOLONG};
  UniqueFd socket(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!socket.valid() ||
      ::connect(socket.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address) != 0) {
    return {{}, errno};
  }
  return {std::move(socket), 0};
}

}  // namespace eyebridge::ports
