#include "remote_robot/message_stream.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <sched.h>
#include <sys/socket.h>

namespace eyebridge::hal {
namespace {

constexpr std::size_t kUsualRoom = 4096;  // bytes
constexpr int kLooks = 50;
using Length = std::uint32_t;

tl::unexpected<Error> gone() {
  return fail(Errc::Disconnected, "the process at the other end of the robot's line is gone");
}

}  // namespace

MessageStream::MessageStream(int socket) : socket_(socket), in_(kUsualRoom) {}

Result<void> MessageStream::send(std::span<const std::uint8_t> message) {
  const auto length = static_cast<Length>(message.size());
  out_.resize(sizeof length);
  std::memcpy(out_.data(), &length, sizeof length);
  out_.insert(out_.end(), message.begin(), message.end());
  for (std::span<const std::uint8_t> rest = out_; !rest.empty();) {
    const ssize_t count = ::send(socket_, rest.data(), rest.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return gone();
    rest = rest.subspan(static_cast<std::size_t>(count));
  }
  return {};
}

Result<Message> MessageStream::receive(Wait wait) {
  if (Result<void> head = fetch(sizeof(Length), wait); !head) return tl::unexpected(head.error());
  Length length = 0;
  std::memcpy(&length, in_.data() + begin_, sizeof length);
  if (length == 0 || length > kLongest) {
    return fail(Errc::Corrupt,
                fmt::format("found a message of {} bytes, expected 1 … {}", length, kLongest));
  }
  if (Result<void> all = fetch(sizeof length + length, Wait::Asleep); !all)
    return tl::unexpected(all.error());
  const auto* const first = in_.data() + begin_ + sizeof length;
  Message message(first, first + length);
  begin_ += sizeof length + length;
  return message;
}

/// So many bytes lie behind begin_ when this returns without an error.
Result<void> MessageStream::fetch(std::size_t wanted, Wait wait) {
  if (end_ - begin_ >= wanted) return {};
  std::copy(in_.begin() + static_cast<std::ptrdiff_t>(begin_),
            in_.begin() + static_cast<std::ptrdiff_t>(end_), in_.begin());
  end_ -= std::exchange(begin_, 0);
  in_.resize(std::max(wanted, kUsualRoom));
  for (int looks = wait == Wait::Awake ? kLooks : 0; end_ < wanted;) {
    const int how = looks > 0 ? MSG_DONTWAIT : 0;
    const ssize_t count = recv(socket_, in_.data() + end_, in_.size() - end_, how);
    if (count > 0) {
      end_ += static_cast<std::size_t>(count);
      continue;
    }
    if (looks > 0 && count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      sched_yield();  // the other end may have this processor only
      --looks;
      continue;
    }
    const bool is_late = count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);
    if (is_late && end_ == 0) return fail(Errc::Timeout, "nothing was asked");
    if (count == 0 || (errno != EINTR && !is_late)) return gone();
  }
  return {};
}

}  // namespace eyebridge::hal
