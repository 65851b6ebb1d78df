#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "eyebridge/base/result.hpp"
#include "remote_robot/byte_ring.hpp"
#include "remote_robot/line_memory.hpp"
#include "remote_robot/message.hpp"

namespace eyebridge::hal {

/// Messages between two processes through shared memory, each preceded by its length. No system
/// calls while both processes are awake. The socket wakes a process that sleeps, and its end of
/// file shows that the other process has ended. One thread at a time.
class MessageStream {
 public:
  /// Longer than any message that makes sense: a hundred thousand bodies in view are ten megabytes.
  static constexpr std::uint32_t kLongest = 64U << 20U;

  enum class End { World, Program };
  enum class Wait {
    Asleep,
    Awake,  ///< Looks for some 30 µs first: to be woken up takes as long, most answers less.
  };

  /// `socket` is lent.
  MessageStream(int socket, LineMemory memory, End end);

  /// Disconnected when the other end is gone, as far as that is known; Corrupt when it has written
  /// nonsense into the memory.
  Result<void> send(std::span<const std::uint8_t> message);
  /// The next message. Disconnected when the other end is gone; Corrupt for a length that no
  /// message has, and for nonsense in the memory; Timeout when none has begun within the socket's
  /// SO_RCVTIMEO.
  Result<Message> receive(Wait wait = Wait::Asleep);

 private:
  Result<void> fetch(std::size_t wanted, Wait wait);
  Result<void> wake() const;
  Result<void> wait_for_sign() const;

  const int socket_;
  const LineMemory memory_;
  RingWriter writer_;
  RingReader reader_;
  std::vector<std::uint8_t> out_;
  std::vector<std::uint8_t> in_;
  std::size_t begin_ = 0;  ///< Of what has come and was not taken …
  std::size_t end_ = 0;    ///< … and its end, in in_.
};

}  // namespace eyebridge::hal
