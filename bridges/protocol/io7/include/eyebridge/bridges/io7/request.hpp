#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "eyebridge/base/result.hpp"
#include "eyebridge/bridges/io7/command_table.hpp"
#include "eyebridge/bridges/io7/profile.hpp"
#include "opcodes.h"

namespace eyebridge::bridges::io7 {

/// The longest request in bytes, in either form.
inline constexpr std::size_t kMaxRequest = 32;

/// One request, whatever it will look like on the wire. Ranges are checked by `encode`.
struct Request {
  char letter = 0;
  std::array<int, kMaxArguments> arguments{};
  std::uint8_t count = 0;  ///< Arguments in use.

  friend constexpr bool operator==(const Request&, const Request&) = default;
};

/// A request of `letter` with `arguments`, in the order of the command page.
template <class... Int>
constexpr Request request(char letter, Int... arguments) {
  static_assert(sizeof...(arguments) <= kMaxArguments);
  return {letter, {static_cast<int>(arguments)...}, sizeof...(arguments)};
}

/// Bytes of a request, held by value.
struct RequestBytes {
  std::array<std::uint8_t, kMaxRequest> bytes{};
  std::uint8_t length = 0;

  [[nodiscard]] std::span<const std::uint8_t> view() const { return {bytes.data(), length}; }
};

/// Writes `request` as `profile` wants it. Fails with Unsupported when the board does not list the
/// letter (or nobody may send it), with OutOfRange when an argument is missing, too many, or
/// outside its range; the text names the argument and the range. Does not allocate unless it fails.
Result<RequestBytes> encode(const Request& request, const Profile& profile);

/// Reads back what `encode` writes, exactly one request: for traces and tests. Fails with Corrupt.
Result<Request> decode_request(std::span<const std::uint8_t> bytes, const Profile& profile);

// Requests by name. Numbers count as the board counts: motors, servos, sensors and encoders from 1,
// ports from 0.

/// Duty in percent, -100 … 100, no control loop.
constexpr Request motor(int motor, int duty_percent) {
  return request(IO7_MOTOR, motor, duty_percent);
}
/// Controlled speed in encoder ticks per 10 ms, -128 … 127.
constexpr Request motor_speed(int motor, int ticks_per_10ms) {
  return request(IO7_MOTOR_SPEED, motor, ticks_per_10ms);
}
/// Gains of the board's speed controller, each 0 … 255.
constexpr Request pid(int motor, int p, int i, int d) { return request(IO7_PID, motor, p, i, d); }
/// Position 0 … 255 between the servo's limits.
constexpr Request servo(int servo, int position) { return request(IO7_SERVO, servo, position); }
/// Pulse widths of positions 0 and 255, in units of 10 microseconds.
constexpr Request servo_limits(int servo, int lower_10us, int upper_10us) {
  return request(IO7_SERVO_LIMITS, servo, lower_10us, upper_10us);
}
constexpr Request psd(int sensor) { return request(IO7_PSD, sensor); }
constexpr Request encoder(int encoder) { return request(IO7_ENCODER, encoder); }
constexpr Request digital_in(int port) { return request(IO7_DIGITAL_IN, port); }
constexpr Request digital_out(int port, bool high) {
  return request(IO7_DIGITAL_OUT, port, high ? 1 : 0);
}
/// `mode` is one of IO7_PORT_INPUT, _OUTPUT, _PULL_UP, _PULL_DOWN.
constexpr Request port_config(int port, char mode) { return request(IO7_PORT_CONFIG, port, mode); }
constexpr Request analog(int port) { return request(IO7_ANALOG, port); }
/// Text replies on or off.
constexpr Request verbose(bool on) { return request(IO7_OUTPUT, on ? 1 : 0); }

}  // namespace eyebridge::bridges::io7
