#include "terminal/terminal_guard.hpp"

#include <atomic>
#include <cerrno>

#include <sys/socket.h>
#include <unistd.h>

#include "eyebridge/base/hidden_process.hpp"

namespace eyebridge::robios {
namespace {

constexpr char kSwitched = 's';
constexpr char kPutBack = 'p';

std::atomic<int> g_line{-1};  // to the guard

/// All that the guard does: its line is descriptor 0, the terminal 1.
[[noreturn]] void watch(const void* mode_before) {
  char state = kPutBack;
  for (;;) {
    char word = 0;
    const ssize_t count = read(0, &word, 1);
    if (count == 1) state = word;
    if (count == 0 || (count < 0 && errno != EINTR)) break;
  }
  if (state == kSwitched) {
    tcsetattr(1, TCSANOW, static_cast<const termios*>(mode_before));
    static_cast<void>(!write(1, kMouseOff, sizeof kMouseOff - 1));
    static_cast<void>(!write(1, kLeavePanel, sizeof kLeavePanel - 1));
  }
  _exit(0);
}

}  // namespace

void guard_terminal(int descriptor, const termios* before) noexcept {
  if (g_line.load() >= 0) return;
  termios mode{};
  if (before != nullptr) {
    mode = *before;
  } else if (tcgetattr(descriptor, &mode) != 0) {
    return;
  }
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return;
  const int kept[] = {ends[1], descriptor};
  const bool started = start_hidden_process("eb:terminal", kept, watch, &mode);
  close(ends[1]);
  if (started) {
    g_line = ends[0];
  } else {
    close(ends[0]);
  }
}

void tell_guard(bool switched) noexcept {
  const int line = g_line;
  const char word = switched ? kSwitched : kPutBack;
  if (line >= 0) static_cast<void>(!send(line, &word, 1, MSG_NOSIGNAL | MSG_DONTWAIT));
}

}  // namespace eyebridge::robios
