#include "board/board_lines.hpp"

#include "arguments/arguments.hpp"

namespace eyebridge::hal {

Result<void> BoardDigital::setup(int line, LineMode mode) {
  return check_line(line).and_then([&] {
    const std::lock_guard lock(mutex_);
    said_[static_cast<std::size_t>(line) - 1].mode = mode;
    return link_.digital_setup(line - 1, mode);
  });
}

Result<bool> BoardDigital::read(int line) {
  return check_line(line).and_then([&] { return link_.digital_in(line - 1); });
}

Result<void> BoardDigital::write(int line, bool high) {
  return check_line(line).and_then([&] {
    const std::lock_guard lock(mutex_);
    said_[static_cast<std::size_t>(line) - 1].high = high;
    return link_.digital_out(line - 1, high);
  });
}

void BoardDigital::restarted() {
  const std::lock_guard lock(mutex_);
  for (int port = 0; port < kCount; ++port) {
    const Said& said = said_[static_cast<std::size_t>(port)];
    // The level first: a line that becomes an output must not drive a wrong one even for a moment.
    if (said.high && !link_.digital_out(port, *said.high)) return;
    if (said.mode && !link_.digital_setup(port, *said.mode)) return;
  }
}

}  // namespace eyebridge::hal
