#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// A serial interface of the computer on the robot. Bytes come and go in real time, whatever clock
/// the robot has.
///
/// The backend owns it; any thread: one may wait for what comes while another one sends. Every call
/// but open() fails with Unsupported before open(), and with Disconnected when the device is gone.
class SerialPort : public Device {
 public:
  /// 8 data bits, no parity, 1 stop bit; `handshake`: the lines RTS and CTS hold back the sender.
  /// Opens it anew when it was open. Fails with Disconnected or Unsupported, in words for people.
  virtual Result<void> open(int baud, bool handshake) = 0;
  /// Waits while the line is full, for one second at most: then Timeout.
  virtual Result<void> send(std::span<const std::uint8_t> bytes) = 0;
  /// Takes what has come into `buffer` and returns how much that is; waits at most `patience` of
  /// real time for the first byte, and returns 0 when none has come.
  virtual Result<std::size_t> receive(std::span<std::uint8_t> buffer, Time patience) = 0;
  /// How many bytes have come that nobody has received.
  virtual Result<std::size_t> pending() = 0;
  /// Forgets them.
  virtual Result<void> flush() = 0;
  /// Ends it; twice does nothing.
  virtual Result<void> close() = 0;
};

}  // namespace eyebridge::hal
