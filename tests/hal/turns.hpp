#pragma once

#include <functional>
#include <memory>

#include "eyebridge/bridges/byte_stream.hpp"
#include "eyebridge/bridges/can_bus.hpp"

namespace eyebridge::hal::testing {

/// Virtual time that a program, its host's threads and a board share by turns, in one thread: the
/// same run every time.
///
/// Whoever waits for the line lets the board live, nobody else: a host's threads queue up behind an
/// exchange anyway. While the program waits everybody lives. Neither may wait in wait_until().
class TurnClock final : public Clock {
 public:
  [[nodiscard]] Time now() const override { return now_; }
  /// The program waits.
  void wait_until(Time deadline) override;
  void spend(Time cost) override { wait_until(now_ + cost); }
  [[nodiscard]] bool is_virtual() const override { return true; }
  /// The host waits for the line.
  void listen_until(Time deadline);

  std::function<void(Time now)> board;     ///< Lives up to now.
  std::function<void(Time until)> listen;  ///< The host's reading thread, where it has one.
  std::function<void()> host;              ///< What its thread does every 10 ms.

 private:
  Time now_{0};
  Time host_due_{0};
  bool listening_ = false;  ///< A reading thread that waits for a lost bus waits in here.
};

/// The host's end of a line of bytes: a wait on it lets the board live.
std::unique_ptr<bridges::ByteStream> by_turns(std::unique_ptr<bridges::ByteStream> line,
                                              TurnClock& clock);
/// Of a bus.
std::unique_ptr<bridges::CanBus> by_turns(std::unique_ptr<bridges::CanBus> bus, TurnClock& clock);

}  // namespace eyebridge::hal::testing
