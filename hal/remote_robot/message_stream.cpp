#include "remote_robot/message_stream.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/format.h>
#include <sched.h>
#include <sys/socket.h>

namespace eyebridge::hal {
namespace {

constexpr std::size_t kUsualRoom = 4096;  // bytes
constexpr int kLooks = 24;
constexpr int kPauses = 32;  // a look: a microsecond or two
using Length = std::uint32_t;

tl::unexpected<Error> gone() {
  return fail(Errc::Disconnected, "the process at the other end of the robot's line is gone");
}

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

/// Polls for about 30 µs; true as soon as `is_ready()` is.
template <typename IsReady>
bool look_for(IsReady is_ready) {
  for (int look = 0; look < kLooks; ++look) {
    for (int i = 0; i < kPauses; ++i) {
      if (is_ready()) return true;
      pause();
    }
    sched_yield();  // the other end may have this processor only
  }
  return false;
}

SharedRing& out_of(const LineMemory& memory, MessageStream::End end) {
  SharedLine& line = memory.line();
  return end == MessageStream::End::World ? line.to_program : line.to_world;
}

SharedRing& in_of(const LineMemory& memory, MessageStream::End end) {
  SharedLine& line = memory.line();
  return end == MessageStream::End::World ? line.to_world : line.to_program;
}

}  // namespace

MessageStream::MessageStream(int socket, LineMemory memory, End end)
    : socket_(socket),
      memory_(std::move(memory)),
      writer_(out_of(memory_, end)),
      reader_(in_of(memory_, end)),
      in_(kUsualRoom) {}

Result<void> MessageStream::send(std::span<const std::uint8_t> message) {
  const auto length = static_cast<Length>(message.size());
  out_.resize(sizeof length);
  std::memcpy(out_.data(), &length, sizeof length);
  out_.insert(out_.end(), message.begin(), message.end());
  for (std::span<const std::uint8_t> rest = out_; !rest.empty();) {
    const Result<std::size_t> count = writer_.write(rest);
    if (!count) return tl::unexpected(count.error());
    rest = rest.subspan(*count);
    if (*count > 0) {
      if (!writer_.must_wake()) continue;
      if (Result<void> woken = wake(); !woken) return woken;
    } else if (!look_for([this] { return !writer_.is_full(); })) {
      writer_.set_asleep(true);
      Result<void> sign = writer_.is_full() ? wait_for_sign() : Result<void>{};
      writer_.set_asleep(false);
      if (!sign && sign.error().code != Errc::Timeout) return sign;
    }
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
  if (Result<void> all = fetch(sizeof length + length, Wait::Awake); !all)
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
  while (end_ < wanted) {
    const Result<std::size_t> count = reader_.read(std::span(in_).subspan(end_));
    if (!count) return tl::unexpected(count.error());
    end_ += *count;
    if (*count > 0) {
      // A failed wake-up means that the other end is gone: reported once everything has been read.
      if (reader_.must_wake()) static_cast<void>(wake());
      continue;
    }
    const auto has_come = [this] { return !reader_.is_empty(); };
    if (wait == Wait::Awake && look_for(has_come)) continue;
    reader_.set_asleep(true);
    Result<void> sign = has_come() ? Result<void>{} : wait_for_sign();
    reader_.set_asleep(false);
    // The other end may have written a last message before it ended.
    if (sign || has_come()) continue;
    if (sign.error().code != Errc::Timeout) return sign;
    if (end_ == 0) return fail(Errc::Timeout, "nothing was asked");
  }
  return {};
}

Result<void> MessageStream::wake() const {
  const char sign = 0;
  ssize_t count = 0;
  do {
    count = ::send(socket_, &sign, 1, MSG_NOSIGNAL | MSG_DONTWAIT);
  } while (count < 0 && errno == EINTR);
  // A full socket also wakes the other end.
  return count > 0 || errno == EAGAIN || errno == EWOULDBLOCK ? Result<void>{} : gone();
}

/// Returns after any sign, also one that was meant for something else. Timeout after SO_RCVTIMEO.
Result<void> MessageStream::wait_for_sign() const {
  std::array<char, 64> signs{};
  const ssize_t count = ::recv(socket_, signs.data(), signs.size(), 0);
  if (count > 0 || (count < 0 && errno == EINTR)) return {};
  if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return fail(Errc::Timeout, "no sign");
  return gone();
}

}  // namespace eyebridge::hal
