#include "can_path.hpp"

#include <cerrno>
#include <cstring>

#include <sys/socket.h>
#include <sys/un.h>

#include "wait.hpp"

namespace eyebridge::bridges {

bool is_can_path(std::string_view interface) {
  return interface.find('/') != std::string_view::npos;
}

Result<CanSocket> connect_can_path(const SocketCanSettings& settings) {
  const std::string& path = settings.interface;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  static_assert(kLongestCanPath < sizeof address.sun_path);
  if (path.size() > kLongestCanPath) {
    return fail(Errc::OutOfRange, path + ": expected a path of at most " +
                                      std::to_string(kLongestCanPath) + " characters");
  }
  std::memcpy(address.sun_path, path.data(), path.size());

  // Like send() and receive() of any bus, connecting must not wait.
  UniqueFd fd(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (fd.valid() &&
      ::connect(fd.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
    return CanSocket{std::move(fd), settings.fd};
  }
  switch (errno) {
    case ENOENT:
    case ECONNREFUSED:
      return fail(Errc::Disconnected,
                  path +
                      ": nobody serves a bus there; expected one, as after: eyebridge firmware "
                      "--world FILE --can " +
                      path + " --node 1");
    case EPROTOTYPE:
    case ENOTSOCK:
      return fail(Errc::Unsupported,
                  path + ": is no socket of a CAN bus; expected one of type SOCK_SEQPACKET");
    default:
      return fail(Errc::Disconnected, path + ": cannot connect: " + errno_text(errno));
  }
}

}  // namespace eyebridge::bridges
