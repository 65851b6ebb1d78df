#pragma once

#include <vector>

#include "eyebridge/ports/port.hpp"

namespace eyebridge::ports {

/// Carries bytes between a non-blocking descriptor and a board.
class FdBytes {
 public:
  explicit FdBytes(ByteLine line) : line_(std::move(line)) {}

  /// Reads and writes until nothing is left to do. False when the other side is gone: `line().lost`
  /// was called then.
  bool pump(int fd);
  [[nodiscard]] bool wants_room() const { return !pending_.empty(); }
  [[nodiscard]] const ByteLine& line() const { return line_; }

 private:
  enum class Outcome { Idle, Moved, Gone };
  Outcome read(int fd);
  Outcome write(int fd);

  ByteLine line_;
  std::vector<std::uint8_t> pending_;
};

}  // namespace eyebridge::ports
