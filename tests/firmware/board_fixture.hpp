#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "eb_board.h"

namespace eyebridge::firmware {

/// The default configuration, changed by `change`.
eb_config config_with(const std::function<void(eb_config&)>& change = {});

/// A board with helpers that speak for the host.
class BoardUnderTest {
 public:
  explicit BoardUnderTest(const eb_config& config = config_with());

  /// Sends bytes; returns all that the board answers at once.
  std::string ask(std::string_view bytes);
  /// Lets time pass in pieces of at most 10 ms; `each` runs after each of them.
  void wait_us(std::uint32_t us, const std::function<void()>& each = {});
  void wait_ms(std::uint32_t ms, const std::function<void()>& each = {}) {
    wait_us(ms * 1000, each);
  }

  /// Sends a frame written as "201#2C01D8DC0700".
  void send(std::string_view frame);
  /// All frames that the board has to send now, in the same form.
  std::vector<std::string> frames();
  /// The host's heartbeat, enable, and what the board says to that, thrown away.
  void enable();

  eb_board board{};
};

/// "181#…" of a frame; FD frames with "##1".
std::string text_of(const eb_can_frame& frame);
/// The other way round; a "#R" is a remote frame.
eb_can_frame frame_of(std::string_view text);

/// A robot without mass on a flat floor: each wheel turns as its duty says, with a lag.
struct Plant {
  double full_ticks = 110;     ///< Ticks per 10 ms at full duty.
  double lag = 0.0;            ///< Seconds.
  bool held = false;           ///< By a wall.
  double speed[EB_MOTORS]{};   ///< Ticks per 10 ms.
  double travel[EB_MOTORS]{};  ///< Ticks.

  /// 10 ms: from the board's duty to its counters.
  void step(eb_board& board);
};

}  // namespace eyebridge::firmware
