#pragma once

#include <cstdint>

#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// What a digital line is used for.
enum class LineMode {
  Input,     ///< Floats where nothing drives it.
  Output,    ///< Drives what write() said last.
  PullUp,    ///< An input that reads 1 where nothing drives it.
  PullDown,  ///< An input that reads 0 where nothing drives it.
};

/// The digital lines of a robot, numbered 1 … kCount as programs do; board ports count from 0. At
/// the start 1 … 8 are inputs with pull-up and 9 … 16 outputs at 0, as on the IO7 board.
///
/// The backend owns them; any thread. A line outside is OutOfRange. Fails with Timeout or
/// Disconnected on hardware.
class DigitalLines : public Device {
 public:
  static constexpr int kCount = 16;

  virtual Result<void> setup(int line, LineMode mode) = 0;
  /// The level at a line; an output reads as what it drives.
  virtual Result<bool> read(int line) = 0;
  /// Of all lines at once: bit n - 1 is line n.
  virtual Result<std::uint16_t> read_all() = 0;
  /// What the line drives; one that is no output will when it becomes one.
  virtual Result<void> write(int line, bool high) = 0;
};

}  // namespace eyebridge::hal
