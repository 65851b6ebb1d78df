#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace eyebridge::bridges {

/// The bytes that stop one robot. The guard sends them and knows no protocol. A plain value: it is
/// sent to another process.
struct StopOrders {
  struct Bytes {
    std::array<std::uint8_t, 192> bytes{};
    std::size_t size = 0;

    /// False when there is no room.
    bool add(std::span<const std::uint8_t> more) {
      if (more.size() > bytes.size() - size) return false;
      std::ranges::copy(more, bytes.begin() + static_cast<std::ptrdiff_t>(size));
      size += more.size();
      return true;
    }
    [[nodiscard]] std::span<const std::uint8_t> view() const { return {bytes.data(), size}; }
  };

  /// What stops the robot, and what it must answer once it has been heard: one write() each.
  std::array<Bytes, 32> writes{};
  std::size_t count = 0;
  /// Comes back only from a board that has obeyed: the bits of `mask`, in a row anywhere in what is
  /// read; at the beginning of a read where `frames`.
  Bytes answer;
  Bytes mask;
  bool frames = false;
  /// A frame that begins so comes from another program, which has the robot from then on. Empty
  /// where the line itself tells.
  Bytes taken;
  /// Ends a request that the board may still be waiting for the rest of; sent before a pause, when
  /// it has not answered.
  Bytes completion;
  /// What makes the board give that answer, too, and does nothing: all that is sent to a line that
  /// was opened again until it is known to lead to the same board. Empty where any line does.
  Bytes question;
  /// The robot stands by itself while its program is silent.
  bool has_watchdog = false;
};

}  // namespace eyebridge::bridges
