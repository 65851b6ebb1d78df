#include "held_line.hpp"

#include <cerrno>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace eyebridge::bridges {
namespace {

constexpr int kConnectTime_ms = 300;

int option(int socket, int name) {
  int value = 0;
  socklen_t size = sizeof value;
  return ::getsockopt(socket, SOL_SOCKET, name, &value, &size) == 0 ? value : -1;
}

}  // namespace

void HeldLine::hold(UniqueFd line, const char* device) {
  line_ = std::move(line);
  device_ = device;
  domain_ = option(line_.get(), SO_DOMAIN);
  is_socket_ = domain_ >= 0;
  if (!is_socket_) {
    ::ioctl(line_.get(), TCGETS2, &settings_);
    return;
  }
  type_ = option(line_.get(), SO_TYPE);
  protocol_ = option(line_.get(), SO_PROTOCOL);
  length_ = sizeof address_;
  auto* const address = reinterpret_cast<sockaddr*>(&address_);
  const int found = domain_ == AF_CAN ? ::getsockname(line_.get(), address, &length_)
                                      : ::getpeername(line_.get(), address, &length_);
  if (found != 0) length_ = 0;
}

bool HeldLine::reopen() {
  if (line_.valid()) return true;
  return is_socket_ ? reopen_socket() : reopen_terminal();
}

void HeldLine::yield() {
  if (is_socket_ || !line_.valid()) return;
  ::flock(line_.get(), LOCK_UN);
  ::ioctl(line_.get(), TIOCNXCL);
}

bool HeldLine::is_taken() const {
  if (is_socket_ || !line_.valid()) return false;
  if (::flock(line_.get(), LOCK_EX | LOCK_NB) != 0) return true;
  ::flock(line_.get(), LOCK_UN);
  return false;
}

bool HeldLine::reopen_terminal() {
  if (std::string_view(device_).starts_with("/dev/pts/")) return false;
  UniqueFd line(::open(device_, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!line.valid()) return false;
  line_ = std::move(line);
  // Not before it is known that nobody else has it.
  if (!is_taken()) ::ioctl(line_.get(), TCSETS2, &settings_);
  return true;
}

bool HeldLine::reopen_socket() {
  if (length_ == 0) return false;
  UniqueFd line(::socket(domain_, type_ | SOCK_NONBLOCK | SOCK_CLOEXEC, protocol_));
  if (!line.valid()) return false;
  const auto* const address = reinterpret_cast<const sockaddr*>(&address_);
  if (domain_ == AF_CAN) {
    if (::bind(line.get(), address, length_) != 0) return false;
  } else if (::connect(line.get(), address, length_) != 0) {
    if (errno != EINPROGRESS) return false;
    pollfd wait{line.get(), POLLOUT, 0};
    if (::poll(&wait, 1, kConnectTime_ms) != 1 || option(line.get(), SO_ERROR) != 0) return false;
  }
  line_ = std::move(line);
  return true;
}

void HeldLine::write(std::span<const std::uint8_t> bytes) {
  if (!line_.valid()) return;
  const ssize_t count = is_socket_ ? ::send(line_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL)
                                   : ::write(line_.get(), bytes.data(), bytes.size());
  if (count < 0) close_if_lost(errno);
}

std::size_t HeldLine::read(std::span<std::uint8_t> buffer) {
  if (!line_.valid()) return 0;
  const ssize_t count = ::read(line_.get(), buffer.data(), buffer.size());
  if (count > 0) return static_cast<std::size_t>(count);
  close_if_lost(count == 0 ? EIO : errno);
  return 0;
}

// A line that is full, or an interface that is down, may take the next one.
void HeldLine::close_if_lost(int error) {
  switch (error) {
    case EAGAIN:
    case EINTR:
    case ENOBUFS:
    case ENETDOWN:
      return;
    default:
      line_.reset();
  }
}

}  // namespace eyebridge::bridges
