#include "terminal/terminal_mode.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <termios.h>
#include <unistd.h>

#include "terminal/terminal_guard.hpp"

namespace eyebridge::robios {
namespace {

// Of XTerm Control Sequences: clicks are reported, and as SGR reports; mode 1006 is harmless where
// it is not known.
constexpr char kMouseOn[] = "\x1b[?1000h\x1b[?1006h";

std::atomic<int> g_keys{-1};   // the terminal that gives keys, or -1
std::atomic<int> g_panel{-1};  // the terminal that shows the panel, or -1
std::atomic<bool> g_mouse = false;
std::atomic<bool> g_released = false;  // once true, it stays as it was found
std::atomic<int> g_interruptions = 0;
std::atomic<pid_t> g_owner = 0;
termios g_before{};  // its mode before; written only while g_keys is -1

void send_text(int descriptor, const char* text) {
  // What a terminal does not take any more is lost: there is nobody to tell.
  static_cast<void>(!write(descriptor, text, std::strlen(text)));
}

extern "C" void restore_and_die(int signal) {
  restore_terminal();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

extern "C" void restore_and_stop(int) {
  restore_terminal();
  ++g_interruptions;
  std::raise(SIGSTOP);
}

void handle(int signal, void (*handler)(int), int flags) {
  struct sigaction current {};
  if (sigaction(signal, nullptr, &current) != 0 || current.sa_handler != SIG_DFL) return;
  struct sigaction ours {};
  ours.sa_handler = handler;
  ours.sa_flags = flags;
  sigemptyset(&ours.sa_mask);
  sigaction(signal, &ours, nullptr);
}

/// Programs overflow their stacks; a handler needs another one then. The calling thread's.
void give_stack_for_handlers() {
  alignas(16) static std::array<char, 65536> room;
  stack_t present{};
  if (sigaltstack(nullptr, &present) != 0 || (present.ss_flags & SS_DISABLE) == 0) return;
  stack_t ours{};
  ours.ss_sp = room.data();
  ours.ss_size = room.size();
  sigaltstack(&ours, nullptr);
}

void watch_ends() {
  g_owner = getpid();
  static const bool watched = [] {
    std::atexit(restore_keys);  // the panel is left to release_terminal(), after its last picture
    give_stack_for_handlers();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGSEGV, SIGBUS, SIGFPE, SIGILL,
                             SIGABRT, SIGPIPE, SIGALRM, SIGUSR1, SIGUSR2, SIGXCPU}) {
      handle(signal, restore_and_die, SA_ONSTACK);
    }
    handle(SIGTSTP, restore_and_stop, SA_RESTART);
    return true;
  }();
  static_cast<void>(watched);
}

}  // namespace

bool in_background(int descriptor) {
  const pid_t owner = tcgetpgrp(descriptor);
  return owner >= 0 && owner != getpgrp();
}

void switch_to_keys(int descriptor, bool mouse) {
  if (g_keys.load() >= 0 || g_released || tcgetattr(descriptor, &g_before) != 0) return;
  termios mode = g_before;
  mode.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  mode.c_cc[VMIN] = 1;
  mode.c_cc[VTIME] = 0;
  watch_ends();
  g_mouse = mouse;
  g_keys = descriptor;
  tcsetattr(descriptor, TCSANOW, &mode);
  if (mouse) send_text(descriptor, kMouseOn);
  if (g_released) {  // meanwhile
    if (mouse) send_text(descriptor, kMouseOff);
    tcsetattr(descriptor, TCSANOW, &g_before);
  }
}

void restore_keys() noexcept {
  const int keys = g_keys.exchange(-1);
  if (keys < 0 || in_background(keys)) return;
  if (g_mouse.exchange(false)) send_text(keys, kMouseOff);
  tcsetattr(keys, TCSANOW, &g_before);
}

bool switch_to_panel(int descriptor) {
  if (g_released) return false;
  watch_ends();
  guard_terminal(descriptor, g_keys.load() >= 0 ? &g_before : nullptr);
  tell_guard(true);
  g_panel = descriptor;
  if (!g_released) return true;
  g_panel = -1;  // meanwhile
  tell_guard(false);
  return false;
}

int terminal_interruptions() { return g_interruptions; }

void restore_terminal() noexcept {
  if (g_owner != getpid()) return;
  restore_keys();
  const int panel = g_panel.exchange(-1);
  if (panel >= 0 && !in_background(panel)) send_text(panel, kLeavePanel);
  if (panel >= 0) tell_guard(false);
}

void release_terminal() noexcept {
  g_released = true;
  restore_terminal();
}

}  // namespace eyebridge::robios
