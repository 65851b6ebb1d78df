#include "eyebridge/base/sent_descriptor.hpp"

#include <cerrno>
#include <cstring>

#include <sys/socket.h>

#include "eyebridge/base/uncancelled.hpp"

namespace eyebridge {
namespace {

constexpr std::size_t kControlSize = CMSG_SPACE(sizeof(int));

}  // namespace

ssize_t send_with_descriptor(int socket, std::span<const std::byte> bytes,
                             int descriptor) noexcept {
  iovec part{const_cast<std::byte*>(bytes.data()), bytes.size()};  // sendmsg() only reads
  alignas(cmsghdr) char control[kControlSize] = {};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  if (descriptor >= 0) {
    message.msg_control = control;
    message.msg_controllen = sizeof control;
    cmsghdr* const header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof descriptor);
    std::memcpy(CMSG_DATA(header), &descriptor, sizeof descriptor);
  }
  const Uncancelled until_sent;
  ssize_t count = 0;
  do {
    count = ::sendmsg(socket, &message, MSG_NOSIGNAL);
  } while (count < 0 && errno == EINTR);
  return count;
}

ssize_t receive_with_descriptor(int socket, std::span<std::byte> room,
                                UniqueFd& descriptor) noexcept {
  iovec part{room.data(), room.size()};
  alignas(cmsghdr) char control[kControlSize] = {};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  const Uncancelled until_received;
  ssize_t count = 0;
  do {
    count = ::recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
  } while (count < 0 && errno == EINTR);
  int came = -1;
  const cmsghdr* const header = count >= 0 ? CMSG_FIRSTHDR(&message) : nullptr;
  if (header != nullptr && header->cmsg_level == SOL_SOCKET && header->cmsg_type == SCM_RIGHTS &&
      header->cmsg_len >= CMSG_LEN(sizeof came)) {
    std::memcpy(&came, CMSG_DATA(header), sizeof came);
  }
  descriptor.reset(came);
  if (count >= 0 && (message.msg_flags & MSG_CTRUNC) != 0) {  // this process has too many open
    errno = EMFILE;
    return -1;
  }
  return count;
}

}  // namespace eyebridge
