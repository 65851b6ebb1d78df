#include "fd_bytes.hpp"

#include <array>
#include <cerrno>

#include <sys/socket.h>
#include <unistd.h>

namespace eyebridge::ports {
namespace {

bool only_waits() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

/// A socket whose other side is gone must not end the process; a terminal knows no send().
ssize_t write_quietly(int fd, const std::vector<std::uint8_t>& bytes) {
  const ssize_t sent = ::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  return sent < 0 && errno == ENOTSOCK ? ::write(fd, bytes.data(), bytes.size()) : sent;
}

}  // namespace

FdBytes::Outcome FdBytes::read(int fd) {
  std::array<std::uint8_t, 512> buffer;
  const ssize_t got = ::read(fd, buffer.data(), buffer.size());
  if (got > 0) {
    line_.receive(std::span(buffer).first(static_cast<std::size_t>(got)));
    return Outcome::Moved;
  }
  return got < 0 && only_waits() ? Outcome::Idle : Outcome::Gone;
}

FdBytes::Outcome FdBytes::write(int fd) {
  if (pending_.empty()) {
    pending_.resize(512);
    pending_.resize(line_.transmit(pending_));
  }
  if (pending_.empty()) return Outcome::Idle;
  const ssize_t sent = write_quietly(fd, pending_);
  if (sent < 0) return only_waits() ? Outcome::Idle : Outcome::Gone;
  pending_.erase(pending_.begin(), pending_.begin() + sent);
  return Outcome::Moved;
}

bool FdBytes::pump(int fd) {
  for (bool moved = true; moved;) {
    const Outcome in = read(fd);
    const Outcome out = in == Outcome::Gone ? in : write(fd);
    if (out == Outcome::Gone) {
      pending_.clear();
      line_.lost();
      return false;
    }
    moved = in == Outcome::Moved || out == Outcome::Moved;
  }
  return true;
}

}  // namespace eyebridge::ports
