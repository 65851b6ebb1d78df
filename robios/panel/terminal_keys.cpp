#include <cerrno>

#include <poll.h>
#include <unistd.h>

#include "key_input.hpp"
#include "terminal/terminal_mode.hpp"

namespace eyebridge::robios {
namespace {

// A program that reads keys in a loop need not ask the system each time: a person is slower.
constexpr std::chrono::milliseconds kNextLook{1};

}  // namespace

TerminalKeys::TerminalKeys(int descriptor, TouchMap touch_map)
    : descriptor_(descriptor), touch_map_(std::move(touch_map)) {}

TerminalKeys::~TerminalKeys() { restore_keys(); }

bool TerminalKeys::wait_for_input(std::chrono::milliseconds timeout) {
  if (in_background(descriptor_)) {
    ::poll(nullptr, 0, static_cast<int>(timeout.count()));
    return false;
  }
  switch_to_keys(descriptor_, touch_map_ != nullptr);
  pollfd waiting{descriptor_, POLLIN, 0};
  // A signal ends it as well: the caller asks again.
  return ::poll(&waiting, 1, static_cast<int>(timeout.count())) > 0;
}

KeyEvent TerminalKeys::poll(std::chrono::milliseconds timeout) {
  if (!open_) return {};
  const auto now = std::chrono::steady_clock::now();
  if (timeout.count() == 0 && now - looked_ < kNextLook) return {};
  if (!wait_for_input(timeout)) {
    looked_ = now;
    return {};
  }
  // Byte by byte: what follows an event waits for the next call, and may be meant for scanf().
  for (bool more = true; more; more = wait_for_input(std::chrono::milliseconds(0))) {
    std::uint8_t byte = 0;
    const ssize_t count = ::read(descriptor_, &byte, 1);
    if (count == 0 || (count < 0 && errno != EINTR && errno != EAGAIN)) {
      open_ = false;
      return {};
    }
    if (count < 0) return {};
    if (const auto event = decoder_.push(byte)) return event_of(*event);
  }
  return {};
}

KeyEvent TerminalKeys::event_of(const TerminalEvent& event) const {
  if (event.key != 0 || event.remote != 0) return {event.key, std::nullopt, event.remote};
  return {0, touch_map_ ? touch_map_(event.column, event.row) : std::nullopt};
}

std::unique_ptr<KeyInput> terminal_keys() {
  return isatty(STDIN_FILENO) == 1 ? std::make_unique<TerminalKeys>(STDIN_FILENO) : nullptr;
}

}  // namespace eyebridge::robios
