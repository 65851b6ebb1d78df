#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/bridges/can_frame.hpp"

namespace eyebridge::bridges {

/// Lets frames through whose identifier agrees with `id` in the bits of `mask`. Standard and
/// extended identifiers never mix; remote frames never pass a filter.
struct CanFilter {
  std::uint32_t id = 0;
  std::uint32_t mask = CanFrame::kMaxStandardId;
  bool extended = false;

  [[nodiscard]] bool passes(const CanFrame& frame) const {
    return frame.extended == extended && !frame.remote && (frame.id & mask) == (id & mask);
  }
};

/// How the controller stands, as its last error frame said.
enum class CanState { Active, Warning, Passive, BusOff };

/// What happened on a bus since it was opened.
struct CanStatistics {
  std::uint64_t sent = 0;
  std::uint64_t received = 0;      ///< Frames that receive() handed out.
  std::uint64_t dropped = 0;       ///< Lost before receive() because nobody fetched them in time.
  std::uint64_t error_frames = 0;  ///< Reports of the controller, whatever they said.
  std::uint64_t no_ack = 0;        ///< Of these: nobody on the bus acknowledged a frame.
  std::uint64_t bus_off = 0;       ///< Of these: the controller left the bus.
  std::uint64_t reconnects = 0;    ///< Times that a lost interface was opened again.
  CanState state = CanState::Active;

  friend bool operator==(const CanStatistics&, const CanStatistics&) = default;
};

/// One node's access to a CAN bus: a SocketCAN interface, a bus in memory.
///
/// Deadlines are moments on the clock that the bus was made with; one that has passed means "only
/// what can be done at once". One thread may send while another receives. Ends with its life.
class CanBus {
 public:
  virtual ~CanBus() = default;

  /// Queues `frame` for the bus, waiting while the queue is full. Fails with OutOfRange for a frame
  /// that cannot be sent (too long, bad identifier, an error frame), Unsupported for FD on a
  /// classic bus, Timeout, or Disconnected.
  virtual Result<void> send(const CanFrame& frame, Time deadline) = 0;

  /// The next frame of another node that passes the filters. Error frames are counted, not handed
  /// out; bus-off is Disconnected. A bus that was lost is tried again by the next call: while it
  /// stays away that fails with Disconnected at its deadline.
  virtual Result<CanFrame> receive(Time deadline) = 0;

  /// From now on only frames that pass one of `filters` are received; none means all.
  virtual Result<void> set_filters(std::span<const CanFilter> filters) = 0;

  /// Any thread.
  [[nodiscard]] virtual CanStatistics statistics() const = 0;
  /// The socket under it, lent: for a guard that outlives this process. -1 where there is none.
  [[nodiscard]] virtual int descriptor() const { return -1; }
  /// What goes through that socket for `frame`.
  [[nodiscard]] virtual CanFrame on_socket(const CanFrame& frame) const { return frame; }

  /// What messages call it: "can0". Lives as long as the bus.
  [[nodiscard]] virtual std::string_view name() const = 0;
};

}  // namespace eyebridge::bridges
