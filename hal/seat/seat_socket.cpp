#include "seat/seat_socket.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/uio.h>

namespace eyebridge::hal {
namespace {

tl::unexpected<Error> gone() {
  return fail(Errc::Disconnected, "the process at the other end of the robot's line is gone");
}

/// Fills `bytes`; false when the other end is gone before.
bool receive_all(int socket, std::span<std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = recv(socket, bytes.data(), bytes.size(), MSG_WAITALL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

Result<void> send_message(int socket, std::span<const std::uint8_t> message) {
  auto length = static_cast<std::uint32_t>(message.size());
  // sendmsg() changes nothing of it.
  auto* const body = const_cast<std::uint8_t*>(message.data());
  std::array<iovec, 2> parts = {{{&length, sizeof length}, {body, message.size()}}};
  msghdr header{};
  header.msg_iov = parts.data();
  header.msg_iovlen = parts.size();
  std::size_t left = sizeof length + message.size();
  for (;;) {
    const ssize_t count = sendmsg(socket, &header, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return gone();
    auto sent = static_cast<std::size_t>(count);
    left -= sent;
    if (left == 0) return {};
    for (iovec& part : parts) {
      const std::size_t of_this = std::min(sent, part.iov_len);
      part.iov_base = static_cast<std::uint8_t*>(part.iov_base) + of_this;
      part.iov_len -= of_this;
      sent -= of_this;
    }
  }
}

Result<Message> receive_message(int socket) {
  std::array<std::uint8_t, sizeof(std::uint32_t)> head{};
  if (!receive_all(socket, head)) return gone();
  std::uint32_t length = 0;
  std::memcpy(&length, head.data(), sizeof length);
  if (length == 0 || length > kLongestMessage) {
    return fail(Errc::Corrupt, fmt::format("found a message of {} bytes, expected 1 … {}", length,
                                           kLongestMessage));
  }
  Message message(length);
  if (!receive_all(socket, message)) return gone();
  return message;
}

}  // namespace eyebridge::hal
