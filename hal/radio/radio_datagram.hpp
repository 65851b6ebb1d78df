#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace eyebridge::hal {

/// What radios of several processes send each other, one UDP datagram each.
///
/// Layout, big-endian: "EBR1", kind (1 byte), sender (1), receiver (1; 0 is everyone), 0 (1), the
/// sender's run (8), then the text of a message, at most 1024 bytes. Senders and receivers are
/// robots' numbers, 1 … 255.
struct RadioDatagram {
  enum class Kind : std::uint8_t {
    Message = 1,
    Hello = 2,  ///< "I am here, who else is?": answered by Here.
    Here = 3,   ///< Repeated every second.
    Bye = 4,
  };

  Kind kind = Kind::Here;
  std::uint8_t sender = 1;
  std::uint8_t receiver = 0;
  std::uint64_t run = 0;  ///< Tells two robots with the same number apart.
  std::string text;       ///< Of a Message only.

  friend bool operator==(const RadioDatagram&, const RadioDatagram&) = default;
};

/// Its bytes.
std::vector<std::uint8_t> encode(const RadioDatagram& datagram);
/// What `bytes` say; nothing when they are no such datagram.
std::optional<RadioDatagram> decode_radio(std::span<const std::uint8_t> bytes);

}  // namespace eyebridge::hal
