#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include "key_input.hpp"

namespace eyebridge::robios {
namespace {

// Process-wide, because a terminal's mode is, and signal handlers have to reach it.
std::atomic<int> g_switched{-1};       // the terminal switched over, or -1
std::atomic<bool> g_released = false;  // once true, it stays as it was found
termios g_before{};                    // its mode before; written only while g_switched is -1

extern "C" void restore_and_die(int signal) {
  restore_terminal();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void watch_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    struct sigaction current {};
    if (sigaction(signal, nullptr, &current) == 0 && current.sa_handler == SIG_DFL) {
      struct sigaction ours {};
      ours.sa_handler = restore_and_die;
      sigemptyset(&ours.sa_mask);
      sigaction(signal, &ours, nullptr);
    }
  }
}

/// Touching one's terminal from the background would stop the process.
bool in_background(int descriptor) {
  const pid_t owner = tcgetpgrp(descriptor);
  return owner >= 0 && owner != getpgrp();
}

/// Takes keys without Enter and without echo.
void switch_over(int descriptor) {
  if (g_switched.load() >= 0 || g_released) {
    return;
  }
  if (tcgetattr(descriptor, &g_before) != 0) {
    return;
  }
  termios mode = g_before;
  mode.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  mode.c_cc[VMIN] = 1;
  mode.c_cc[VTIME] = 0;
  static const bool watched = [] {
    std::atexit(restore_terminal);
    watch_signals();
    return true;
  }();
  static_cast<void>(watched);
  g_switched.store(descriptor);
  tcsetattr(descriptor, TCSANOW, &mode);
  if (g_released) {  // meanwhile
    tcsetattr(descriptor, TCSANOW, &g_before);
  }
}

}  // namespace

void restore_terminal() noexcept {
  const int descriptor = g_switched.exchange(-1);
  if (descriptor >= 0) {
    tcsetattr(descriptor, TCSANOW, &g_before);
  }
}

void release_terminal() noexcept {
  g_released = true;
  restore_terminal();
}

TerminalKeys::TerminalKeys(int descriptor) : descriptor_(descriptor) {}

TerminalKeys::~TerminalKeys() { restore_terminal(); }

int TerminalKeys::poll(std::chrono::milliseconds timeout) {
  if (!open_) {
    return 0;
  }
  if (in_background(descriptor_)) {
    ::poll(nullptr, 0, static_cast<int>(timeout.count()));
    return 0;
  }
  switch_over(descriptor_);
  pollfd waiting{descriptor_, POLLIN, 0};
  if (::poll(&waiting, 1, static_cast<int>(timeout.count())) <= 0) {
    return 0;  // nothing typed, or a signal: the caller asks again
  }
  char typed = 0;
  const ssize_t count = ::read(descriptor_, &typed, 1);
  if (count == 0 || (count < 0 && errno != EINTR && errno != EAGAIN)) {
    open_ = false;
    return 0;
  }
  return count == 1 && typed >= '1' && typed <= '4' ? 1 << (typed - '1') : 0;
}

std::unique_ptr<KeyInput> terminal_keys() {
  return isatty(STDIN_FILENO) == 1 ? std::make_unique<TerminalKeys>(STDIN_FILENO) : nullptr;
}

}  // namespace eyebridge::robios
