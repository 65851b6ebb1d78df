#pragma once

#include <chrono>

namespace eyebridge {

/// A moment or a span on a robot's clock. Clocks start at 0 when the session starts.
using Time = std::chrono::nanoseconds;

constexpr double to_seconds(Time t) { return std::chrono::duration<double>(t).count(); }
/// `seconds`, to the nearest nanosecond. |seconds| < 9e9.
constexpr Time from_seconds(double seconds) {
  return Time(static_cast<Time::rep>(seconds * 1e9 + (seconds < 0 ? -0.5 : 0.5)));
}

/// The time a robot program lives in: wall time, wall time scaled, virtual time or a board's time.
///
/// Passed in everywhere; nothing asks the system for the time behind its back.
class Clock {
 public:
  virtual ~Clock() = default;

  /// Time since the start of the session. Any thread.
  [[nodiscard]] virtual Time now() const = 0;
  /// What this clock showed when the computer's CLOCK_MONOTONIC, in which drivers stamp what they
  /// take, showed `moment`, which has been. Virtual clocks, which do not follow that one: now().
  /// Any thread.
  [[nodiscard]] virtual Time at([[maybe_unused]] Time moment) const { return now(); }
  /// Returns when now() >= `deadline`; at once when that is already so. Any thread.
  virtual void wait_until(Time deadline) = 0;
  /// Charges a call for the time that it takes on a real robot. Virtual clocks advance by `cost`;
  /// clocks that run by themselves do nothing.
  virtual void spend(Time cost) = 0;
  /// True when time moves only through wait_until() and spend().
  [[nodiscard]] virtual bool is_virtual() const = 0;
};

}  // namespace eyebridge
