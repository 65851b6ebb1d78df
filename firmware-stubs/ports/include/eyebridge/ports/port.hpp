#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "eb_can.h"

struct eb_board;
struct rv_rover;

namespace eyebridge::ports {

/// The board's end of a line of bytes: what a port calls. All are set.
struct ByteLine {
  std::function<void(std::span<const std::uint8_t>)> receive;  ///< What the host sent.
  /// Fills its argument with what the host is to get; returns how many bytes these are.
  std::function<std::size_t(std::span<std::uint8_t>)> transmit;
  std::function<void()> lost;  ///< The host is gone.
};

/// The board's end of a CAN bus.
struct FrameLine {
  std::function<void(const eb_can_frame&)> receive;
  std::function<bool(eb_can_frame&)> transmit;  ///< The next frame; false when there is none.
  std::function<void()> lost;                   ///< The controller left the bus.
};

/// The line or bus of a board or rover, which must outlive it.
ByteLine byte_line(eb_board& board);
FrameLine frame_line(eb_board& board);
FrameLine frame_line(rv_rover& rover);

/// What carries one board's line to its host. Never waits; one thread. Closes with its life.
class Port {
 public:
  virtual ~Port() = default;

  /// Carries whatever there is in both directions.
  virtual void pump() = 0;
  /// What to poll() for, so that the next pump() finds something; -1: nothing to wait for now.
  [[nodiscard]] virtual int descriptor() const = 0;
  /// Whether poll() should wait for room, too (POLLOUT).
  [[nodiscard]] virtual bool wants_room() const { return false; }
  /// A host is there, as far as this kind of line can tell.
  [[nodiscard]] virtual bool connected() const = 0;
  /// What a program names to reach the board: "serial:./eyebot.tty".
  [[nodiscard]] virtual std::string address() const = 0;
};

/// A port over anything that carries bytes without waiting, such as a pair in memory. `read` fills
/// its argument and returns the number of bytes, 0 for none yet, -1 when the host is gone; `write`
/// takes all.
struct ByteFunctions {
  std::function<std::ptrdiff_t(std::span<std::uint8_t>)> read;
  std::function<void(std::span<const std::uint8_t>)> write;
};
std::unique_ptr<Port> make_memory_port(ByteLine line, ByteFunctions functions);

/// The same for frames. `read` returns 1 for a frame, 0 for none yet, -1 when the bus is gone.
struct FrameFunctions {
  std::function<int(eb_can_frame&)> read;
  std::function<void(const eb_can_frame&)> write;
};
std::unique_ptr<Port> make_memory_port(FrameLine line, FrameFunctions functions);

}  // namespace eyebridge::ports
