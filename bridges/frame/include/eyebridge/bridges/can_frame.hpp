#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace eyebridge::bridges {

/// One CAN frame, classic or FD.
struct CanFrame {
  static constexpr std::size_t kMaxClassic = 8;  ///< Bytes in a classic frame.
  static constexpr std::size_t kMaxFd = 64;      ///< Bytes in an FD frame.
  static constexpr std::uint32_t kMaxStandardId = 0x7FF;
  static constexpr std::uint32_t kMaxExtendedId = 0x1FFF'FFFF;

  std::uint32_t id = 0;     ///< 11 bits, or 29 when `extended`; the error class when `error`.
  std::uint8_t length = 0;  ///< Bytes of `data` in use; with `remote` the number that is asked for.
  bool extended = false;    ///< 29-bit identifier.
  bool remote = false;      ///< Asks for a frame (RTR): carries no data. Classic only.
  bool error = false;       ///< A report of the controller, never on the bus (linux/can/error.h).
  bool fd = false;          ///< CAN FD: up to 64 bytes.
  bool bit_rate_switch = false;        ///< FD: data at the higher rate.
  bool error_state_indicator = false;  ///< FD: the sender is error-passive.
  std::array<std::uint8_t, kMaxFd> data{};

  /// The bytes in use; none for a remote frame.
  [[nodiscard]] std::span<const std::uint8_t> bytes() const {
    return {data.data(), remote ? std::size_t{0} : std::min<std::size_t>(length, kMaxFd)};
  }
  /// Equal when the bytes in use and everything else are.
  friend bool operator==(const CanFrame& a, const CanFrame& b) {
    return a.id == b.id && a.length == b.length && a.extended == b.extended &&
           a.remote == b.remote && a.error == b.error && a.fd == b.fd &&
           a.bit_rate_switch == b.bit_rate_switch &&
           a.error_state_indicator == b.error_state_indicator &&
           std::ranges::equal(a.bytes(), b.bytes());
  }
};

/// Whether a controller can send that many bytes: 0 … 8, and for FD also 12, 16, 20, 24, 32,
/// 48, 64.
constexpr bool is_can_length(std::size_t length, bool fd) {
  if (length <= CanFrame::kMaxClassic) return true;
  return fd && length <= CanFrame::kMaxFd &&
         (length <= 24 ? length % 4 == 0 : length == 32 || length == 48 || length == 64);
}

/// Null when `frame` can be sent; else what is wrong with it, one line.
const char* why_not_sendable(const CanFrame& frame);

}  // namespace eyebridge::bridges
