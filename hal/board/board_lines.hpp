#pragma once

#include <array>
#include <mutex>
#include <optional>

#include "board/board_link.hpp"
#include "eyebridge/hal/digital_lines.hpp"

namespace eyebridge::hal {

/// The digital lines of a board: line n of a program is port n - 1 of the board.
class BoardDigital final : public DigitalLines {
 public:
  explicit BoardDigital(BoardLink& link) : link_(link) {}

  Result<void> setup(int line, LineMode mode) override;
  Result<bool> read(int line) override;
  Result<std::uint16_t> read_all() override { return link_.digital_in_all(); }
  Result<void> write(int line, bool high) override;

  /// Says again what the program has said, to a board that forgot it.
  void restarted();

 private:
  struct Said {
    std::optional<LineMode> mode;
    std::optional<bool> high;
  };

  BoardLink& link_;
  std::mutex mutex_;
  std::array<Said, kCount> said_;
};

}  // namespace eyebridge::hal
