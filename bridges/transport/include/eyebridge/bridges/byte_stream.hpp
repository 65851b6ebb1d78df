#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"

namespace eyebridge::bridges {

/// A line that carries bytes both ways: serial port, TCP connection, memory pair.
///
/// Deadlines are moments on the clock that the stream was made with; one that has passed means
/// "only what can be done at once". One thread may read while another writes; nothing else runs at
/// the same time. A stream that reported Disconnected stays so: open a new one.
class ByteStream {
 public:
  virtual ~ByteStream() = default;

  /// Takes what has arrived into `buffer` (not empty), waiting for the first byte, and returns how
  /// many bytes these are: at least 1. Fails with Timeout, or Disconnected when the other side is
  /// gone and all that it sent has been read.
  virtual Result<std::size_t> read_some(std::span<std::uint8_t> buffer, Time deadline) = 0;

  /// Takes what has arrived already, without waiting: 0 bytes when nothing has. `buffer` is not
  /// empty. Fails with Disconnected as read_some() does.
  virtual Result<std::size_t> read_now(std::span<std::uint8_t> buffer) {
    auto count = read_some(buffer, Time{0});
    if (!count && count.error().code == Errc::Timeout) return std::size_t{0};
    return count;
  }

  /// Hands over all of `bytes`, waiting while the line is full. Fails with Timeout, where a part
  /// may have gone out, or Disconnected.
  virtual Result<void> write_all(std::span<const std::uint8_t> bytes, Time deadline) = 0;

  /// Ends the line; the other side reads the rest and then Disconnected. Later calls here fail with
  /// Disconnected. Happens by itself at the end of the stream's life; twice does nothing.
  virtual void close() = 0;

  /// The file descriptor under it, lent until close(): for a guard that outlives this process. -1
  /// where there is none.
  [[nodiscard]] virtual int descriptor() const { return -1; }

  /// What messages call it: "/dev/ttyACM0", "robot:4711". Lives as long as the stream.
  [[nodiscard]] virtual std::string_view name() const = 0;
};

}  // namespace eyebridge::bridges
