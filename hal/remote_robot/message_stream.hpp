#pragma once

#include <cstdint>
#include <span>

#include "eyebridge/base/result.hpp"
#include "remote_robot/message.hpp"

namespace eyebridge::hal {

/// Messages over a stream socket, each behind its length, in as few system calls as can be. One
/// thread at a time.
class MessageStream {
 public:
  /// Longer than any message that makes sense: a hundred thousand bodies in view are ten megabytes.
  static constexpr std::uint32_t kLongest = 64U << 20U;

  enum class Wait {
    Asleep,
    Awake,  ///< Looks for some 30 µs first: to be woken up takes as long, most answers less.
  };

  /// `socket` is lent.
  explicit MessageStream(int socket);

  /// Disconnected when the other end is gone.
  Result<void> send(std::span<const std::uint8_t> message);
  /// The next message. Disconnected when the other end is gone, Corrupt for a length that no
  /// message has; Timeout when none has begun within the socket's SO_RCVTIMEO.
  Result<Message> receive(Wait wait = Wait::Asleep);

 private:
  Result<void> fetch(std::size_t wanted, Wait wait);

  const int socket_;
  std::vector<std::uint8_t> out_;
  std::vector<std::uint8_t> in_;
  std::size_t begin_ = 0;  ///< Of what has come and was not taken …
  std::size_t end_ = 0;    ///< … and its end, in in_.
};

}  // namespace eyebridge::hal
