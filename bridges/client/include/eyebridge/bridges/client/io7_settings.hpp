#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/bridges/client/run_probe.hpp"

namespace eyebridge::bridges {

/// How patient a client is with its board.
struct Io7Settings {
  /// The longest wait for a reply; four times what the probe measured where that is longer. Once
  /// replies are known to be faster the client waits ten times what they take, but at least
  /// `reply_least`; the whole of it when it asks again.
  Time reply_timeout = std::chrono::milliseconds(50);
  Time reply_least = std::chrono::milliseconds(20);
  /// The same on a noisy line, where many replies will never come.
  Time noisy_least = std::chrono::milliseconds(5);
  /// For what a resync sends, and for the last `v` that a silent board is asked.
  Time resync_timeout = std::chrono::milliseconds(200);
  ProbeTiming probe{};
  Time boot_patience = std::chrono::seconds(3);  ///< Opening a port resets some boards: they are
                                                 ///< deaf for a while.
  /// Then `v` is asked: so that a loss is noticed, and so that boards that stop their motors for
  /// want of a host (after 300 ms) go on.
  Time idle = std::chrono::milliseconds(100);
  Time first_backoff = std::chrono::milliseconds(200);  ///< Between attempts to open a lost line …
  Time longest_backoff = std::chrono::seconds(2);       ///< … doubling up to this.
  /// A LineGuard stops the motors when this process is gone. Only for lines with a descriptor.
  bool guarded = false;
  std::optional<Time> said_timeout;  ///< The longest wait for a reply, whatever the probe measured.
  // What the user says of the board goes before what the probe finds.
  std::optional<io7::RequestForm> said_requests;
  std::optional<io7::ByteOrder> said_byte_order;
  bool vw_letters = false;  ///< Allow the undocumented v-omega letters, where listed.
};

/// What happened on a line to a board since the client was made.
struct Io7Statistics {
  std::uint64_t requests = 0;  ///< Exchanges that were asked for.
  std::uint64_t answered = 0;  ///< Replies that came and were right.
  std::uint64_t retries = 0;
  std::uint64_t resyncs = 0;
  std::uint64_t timeouts = 0;       ///< No reply in time.
  std::uint64_t corrupt = 0;        ///< A reply that could not be right, or was followed by more.
  std::uint64_t stray = 0;          ///< Bytes that belonged to no reply.
  std::uint64_t disagreements = 0;  ///< Readings that the others of the same thing deny.
  std::uint64_t repeated = 0;       ///< Orders that were sent again because the line is noisy.
  std::uint64_t losses = 0;         ///< The line was lost.
  std::uint64_t connects = 0;       ///< A board was found and made ready.
  Time latency_min = Time::max();   ///< From the first byte out to the last byte in.
  Time latency_max{0};
  Time latency_sum{0};  ///< Of `answered` replies.

  [[nodiscard]] Time latency_mean() const {
    return answered == 0 ? Time{0} : latency_sum / static_cast<Time::rep>(answered);
  }
};

}  // namespace eyebridge::bridges
