#include "terminal/terminal_guard.hpp"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace eyebridge::robios {
namespace {

constexpr char kSwitched = 's';
constexpr char kPutBack = 'p';

std::atomic<int> g_line{-1};  // to the guard

/// All that the guard does. A copy of one thread of a process that may have many: system calls
/// only.
[[noreturn]] void watch(int line, int terminal, const termios& before) {
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
  setsid();  // Ctrl-C is not for it, and it may set the mode of a terminal that others have by then
  prctl(PR_SET_NAME, "eb:terminal");
  // Nothing of the program's may stay open because of it.
  if (terminal == 0) terminal = dup(terminal);
  dup2(line, 0);
  dup2(terminal, 1);
  if (syscall(SYS_close_range, 2U, ~0U, 0U) != 0) {
    for (int descriptor = 2; descriptor < 1024; ++descriptor) close(descriptor);
  }
  char state = kPutBack;
  for (;;) {
    char word = 0;
    const ssize_t count = read(0, &word, 1);
    if (count == 1) state = word;
    if (count == 0 || (count < 0 && errno != EINTR)) break;
  }
  if (state == kSwitched) {
    tcsetattr(1, TCSANOW, &before);
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
  // A fork() without the handlers of fork() and without a signal when it ends, so that neither the
  // program nor its wait() notices.
  const long child = syscall(SYS_clone, 0L, 0L, 0L, 0L, 0L);
  if (child == 0) {
    close(ends[0]);
    watch(ends[1], descriptor, mode);
  }
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
  } else {
    g_line = ends[0];
  }
}

void tell_guard(bool switched) noexcept {
  const int line = g_line;
  const char word = switched ? kSwitched : kPutBack;
  if (line >= 0) static_cast<void>(!send(line, &word, 1, MSG_NOSIGNAL | MSG_DONTWAIT));
}

}  // namespace eyebridge::robios
